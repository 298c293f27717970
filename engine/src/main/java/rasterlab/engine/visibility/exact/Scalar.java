package rasterlab.engine.visibility.exact;

/**
 * A number of one of two kinds, so that a formula is written once: {@link Bounded} is fast, {@link
 * Dyadic} is exact.
 *
 * @param <S> the kind
 */
interface Scalar<S extends Scalar<S>> {
    S plus(S other);

    S minus(S other);

    S times(S other);
}
