package rasterlab.engine.visibility.exact;

/**
 * A point or a direction.
 *
 * @param <S> the kind of its numbers
 */
record Triple<S extends Scalar<S>>(S x, S y, S z) {
    Triple<S> plus(Triple<S> other) {
        return new Triple<>(x.plus(other.x), y.plus(other.y), z.plus(other.z));
    }

    Triple<S> minus(Triple<S> other) {
        return new Triple<>(x.minus(other.x), y.minus(other.y), z.minus(other.z));
    }

    S dot(Triple<S> other) {
        return x.times(other.x).plus(y.times(other.y)).plus(z.times(other.z));
    }

    Triple<S> cross(Triple<S> other) {
        return new Triple<>(
                y.times(other.z).minus(z.times(other.y)),
                z.times(other.x).minus(x.times(other.z)),
                x.times(other.y).minus(y.times(other.x)));
    }
}
