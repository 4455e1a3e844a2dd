//! Operators for all combinations of values and references.

/// Implements a binary operator of a type for references by an expression, and for all other combinations of values and
/// references by that; with a second pair of names its assignment form as well.
macro_rules! binary_operator {
    ($Type:ty: $Op:ident $op:ident, |$a:ident, $b:ident| $result:expr) => {
        impl std::ops::$Op<&$Type> for &$Type {
            type Output = $Type;

            #[inline]
            fn $op(self, other: &$Type) -> $Type {
                let ($a, $b) = (self, other);
                $result
            }
        }

        impl std::ops::$Op<$Type> for $Type {
            type Output = $Type;

            #[inline]
            fn $op(self, other: $Type) -> $Type {
                std::ops::$Op::$op(&self, &other)
            }
        }

        impl std::ops::$Op<&$Type> for $Type {
            type Output = $Type;

            #[inline]
            fn $op(self, other: &$Type) -> $Type {
                std::ops::$Op::$op(&self, other)
            }
        }

        impl std::ops::$Op<$Type> for &$Type {
            type Output = $Type;

            #[inline]
            fn $op(self, other: $Type) -> $Type {
                std::ops::$Op::$op(self, &other)
            }
        }
    };
    ($Type:ty: $Op:ident $op:ident $OpAssign:ident $op_assign:ident, |$a:ident, $b:ident| $result:expr) => {
        binary_operator!($Type: $Op $op, |$a, $b| $result);

        impl std::ops::$OpAssign<&$Type> for $Type {
            #[inline]
            fn $op_assign(&mut self, other: &$Type) {
                *self = std::ops::$Op::$op(&*self, other);
            }
        }

        impl std::ops::$OpAssign<$Type> for $Type {
            #[inline]
            fn $op_assign(&mut self, other: $Type) {
                *self = std::ops::$Op::$op(&*self, &other);
            }
        }
    };
}

pub(crate) use binary_operator;
