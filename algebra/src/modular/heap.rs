//! The heap of products by which sparse polynomials are divided.

/// The next product of each term of a divisor with a term of the quotient, the largest monomial first (Johnson, *Sparse
/// polynomial arithmetic*, 1974).
///
/// A binary heap like that of the standard library, which is several times slower where nothing is inlined, as in a macro
/// that is built without optimization.
#[derive(Debug, Default)]
pub(crate) struct ProductHeap {
    products: Vec<NextProduct>,
}

/// A product of two terms that waits to be taken off.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NextProduct {
    /// Its monomial.
    pub(crate) word: u128,
    /// The place of the term of the divisor.
    pub(crate) divisor: usize,
    /// The place of the term of the quotient.
    pub(crate) quotient: usize,
}

impl ProductHeap {
    /// A product with the largest monomial; `None` if no product waits.
    pub(crate) fn top(&self) -> Option<NextProduct> {
        self.products.first().copied()
    }

    /// The product with the largest monomial, if that is `word`.
    pub(crate) fn top_at(&self, word: u128) -> Option<NextProduct> {
        match self.products.as_slice() {
            [top, ..] if top.word == word => Some(*top),
            _ => None,
        }
    }

    /// Adds a product.
    pub(crate) fn push(&mut self, product: NextProduct) {
        self.products.push(product);
        let products = self.products.as_mut_slice();
        let mut place = products.len() - 1;
        while place > 0 {
            let parent = (place - 1) / 2;
            if products[parent].word >= product.word {
                break;
            }
            products[place] = products[parent];
            place = parent;
        }
        products[place] = product;
    }

    /// Takes off the top.
    pub(crate) fn pop(&mut self) {
        if let Some(last) = self.products.pop()
            && !self.products.is_empty()
        {
            self.replace_top(last);
        }
    }

    /// Puts a product in the place of the top, which is there.
    pub(crate) fn replace_top(&mut self, product: NextProduct) {
        let products = self.products.as_mut_slice();
        let count = products.len();
        let mut place = 0;
        loop {
            let mut child = 2 * place + 1;
            if child >= count {
                break;
            }
            if child + 1 < count && products[child + 1].word > products[child].word {
                child += 1;
            }
            if products[child].word <= product.word {
                break;
            }
            products[place] = products[child];
            place = child;
        }
        products[place] = product;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn products_come_in_descending_order(words in prop::collection::vec(0_u128..20, 1..40), changed in 0_u128..20) {
            let mut heap = ProductHeap::default();
            for (divisor, &word) in words.iter().enumerate() {
                heap.push(NextProduct { word, divisor, quotient: 0 });
            }
            let mut expected = words.clone();
            expected.sort_unstable_by(|a, b| b.cmp(a));
            prop_assert_eq!(heap.top().map(|top| top.word), expected.first().copied());
            expected[0] = changed;
            expected.sort_unstable_by(|a, b| b.cmp(a));
            heap.replace_top(NextProduct { word: changed, divisor: 0, quotient: 0 });
            let mut found = Vec::new();
            while let Some(top) = heap.top() {
                prop_assert!(heap.top_at(top.word).is_some() && heap.top_at(top.word + 1).is_none());
                found.push(top.word);
                heap.pop();
            }
            prop_assert_eq!(found, expected);
        }
    }
}
