package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/**
 * Recorded steps, or a list of them for each thing that was walked for, as {@link RecordedSteps}
 * writes.
 */
public final class StepsShape extends EitherShape<List<List<Written>>> {
    private static final Shape<List<Written>> STEPS = Shape.list(new OpenShape());
    private static final Shape<List<List<Written>>> LISTS = Shape.list(STEPS);

    /** The formula of the value by which the method decides. */
    public static final Field<String> DECISION = Field.optional("decision", Shape.text());

    public static final Field<?> FIELD = Field.optional("steps", new StepsShape());

    private StepsShape() {
        super(STEPS, LISTS);
    }

    @Override
    public List<List<Written>> read(ValueSource in) throws IOException {
        return LISTS.read(in);
    }

    @Override
    public void write(List<List<Written>> value, ValueSink out) throws IOException {
        LISTS.write(value, out);
    }
}
