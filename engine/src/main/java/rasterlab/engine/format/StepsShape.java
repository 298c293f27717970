package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/**
 * Recorded steps, or a list of them for each thing that was walked for, as {@link Steps} writes.
 */
public final class StepsShape extends EitherShape<List<?>> {
    private static final Shape<List<Given>> STEPS = Shape.list(new OpenShape());
    private static final Shape<List<List<Given>>> LISTS = Shape.list(STEPS);

    /** The formula of the value by which the method decides. */
    public static final Field<String> DECISION = Field.optional("decision", Shape.text());

    public static final Field<List<?>> FIELD = Field.optional("steps", new StepsShape());

    private StepsShape() {
        super(STEPS, LISTS);
    }

    @Override
    public List<?> read(ValueSource in) throws IOException {
        return Shape.list(new Part()).read(in);
    }

    /** A step, or the steps for one thing. */
    private static final class Part extends EitherShape<Object> {
        Part() {
            super(new OpenShape(), STEPS);
        }

        @Override
        public Object read(ValueSource in) throws IOException {
            return in.startsArray() ? STEPS.read(in) : new OpenShape().read(in);
        }
    }
}
