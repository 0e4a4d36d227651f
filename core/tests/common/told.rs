//! What a criticism says, looked at in every language.

use gyradius_core::critique::Critique;
use gyradius_core::language::Language;

/// Nothing is said in one language alone: the words are those of the sentence with its keys, and
/// German has each of them.
pub fn told_in_every_language(critique: &Critique) {
    let mut all = vec![(&critique.verdict.text, &critique.verdict.said)];
    all.extend(
        critique
            .verdict
            .next_swing
            .iter()
            .map(|next| (&next.text, &next.said)),
    );
    all.extend(
        critique
            .causes
            .iter()
            .map(|cause| (&cause.text, &cause.said)),
    );
    all.extend(
        critique
            .discrepancies
            .iter()
            .map(|found| (&found.text, &found.said)),
    );
    assert_eq!(critique.warnings.len(), critique.warnings_said.len());
    all.extend(critique.warnings.iter().zip(&critique.warnings_said));
    for (text, said) in all {
        assert_eq!(*text, said.in_language(Language::English));
        let german = said.in_language(Language::German);
        println!("  {german}");
        assert!(
            !german.is_empty() && german != *text && !german.contains('{'),
            "{text}: {german}"
        );
        // What is spelled as in a file is a swing's name, the same in every language, and no key.
        let mut spelled = german.split_whitespace().filter(|word| word.contains('_'));
        assert!(
            spelled.all(|word| text.contains(word.trim_matches([',', ':', '.']))),
            "{text}: {german}"
        );
    }
}
