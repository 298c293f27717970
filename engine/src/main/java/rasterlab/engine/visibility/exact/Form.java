package rasterlab.engine.visibility.exact;

/**
 * A linear function of the pixel: {@code base + x·perColumn + y·perRow}.
 *
 * @param <S> the kind of its numbers
 */
record Form<S extends Scalar<S>>(S base, S perColumn, S perRow) {
    Form<S> plus(Form<S> other) {
        return new Form<>(
                base.plus(other.base), perColumn.plus(other.perColumn), perRow.plus(other.perRow));
    }

    Form<S> minus(Form<S> other) {
        return new Form<>(
                base.minus(other.base),
                perColumn.minus(other.perColumn),
                perRow.minus(other.perRow));
    }

    Form<S> times(S factor) {
        return new Form<>(base.times(factor), perColumn.times(factor), perRow.times(factor));
    }

    /** This form with another constant. */
    Form<S> plus(S constant) {
        return new Form<>(base.plus(constant), perColumn, perRow);
    }
}
