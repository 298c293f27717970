package rasterlab.engine.visibility.exact;

/**
 * A plane as the pixels see it: nearness is U/V, with U linear in the pixel and V above 0.
 *
 * <p>Nearness τ is s·ρ/z in perspective and −s·z in parallel projection, for s pixels per unit: the
 * larger, the nearer. Unlike z, it is linear in the pixel.
 *
 * @param <S> the kind of its numbers
 */
record SeenPlane<S extends Scalar<S>>(Form<S> u, S v) {
    /** Both numbers times a factor. */
    SeenPlane<S> times(S factor) {
        return new SeenPlane<>(u.times(factor), v.times(factor));
    }

    /** The form above 0 at the pixels at which this plane is nearer than another: U₁·V₂ − U₂·V₁. */
    Form<S> before(SeenPlane<S> other) {
        return u.times(other.v).minus(other.u.times(v));
    }
}
