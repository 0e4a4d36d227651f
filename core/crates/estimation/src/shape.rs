//! How many parameters there are, and which belong to one block alone.

use std::ops::Range;

/// The order of all parameters: first those that every block shares, then the own parameters of
/// the first block, then those of the second, and so on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Shape {
    shared: usize,
    /// Where each block's own parameters begin; the last entry is the count of all.
    begins: Vec<usize>,
}

impl Shape {
    /// So many shared parameters, and so many own ones of each block.
    pub fn new(shared: usize, own: &[usize]) -> Self {
        let mut begins = vec![shared];
        begins.extend(own.iter().scan(shared, |at, count| {
            *at += count;
            Some(*at)
        }));
        Self { shared, begins }
    }

    /// So many parameters of one block of data: all are shared, none is its own.
    pub fn single(count: usize) -> Self {
        Self::new(count, &[0])
    }

    /// Count of the shared parameters.
    pub fn shared(&self) -> usize {
        self.shared
    }

    /// Count of the blocks.
    pub fn blocks(&self) -> usize {
        self.begins.len() - 1
    }

    /// Count of all parameters.
    pub fn total(&self) -> usize {
        self.begins[self.blocks()]
    }

    /// Places of a block's own parameters; none where there is no such block.
    pub fn own(&self, block: usize) -> Range<usize> {
        match self.begins.get(block..block + 2) {
            Some(&[first, end]) => first..end,
            _ => self.total()..self.total(),
        }
    }

    /// The block that a parameter is an own one of; none for a shared one.
    pub fn block_of(&self, place: usize) -> Option<usize> {
        let begun = self.begins.partition_point(|first| *first <= place);
        begun.checked_sub(1).filter(|b| *b < self.blocks())
    }
}
