//! What a criticism says, looked at in every language.

use gyradius_base::language::Language;
use gyradius_diagnosis::Critique;

/// Nothing is said in one language alone: the words are those of the sentence with its keys, and
/// German has each of them.
pub fn told_in_every_language(critique: &Critique) {
    let mut all = vec![&critique.verdict.message];
    all.extend(critique.verdict.next_swing.iter().map(|next| &next.message));
    all.extend(critique.causes.iter().map(|cause| &cause.message));
    all.extend(critique.discrepancies.iter().map(|found| &found.message));
    all.extend(&critique.warnings);
    for said in all {
        let text = &said.english;
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
