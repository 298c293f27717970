package rasterlab.engine.format;

import java.io.IOException;

/** A number of a range. */
record NumberShape(double least, double most, IncludedEnds range) implements Shape<Double> {
    /** Which ends of a range belong to it. */
    enum IncludedEnds {
        /** Every finite number. */
        ANY,
        CLOSED,
        /** Numbers above the least, which is left out. */
        ABOVE
    }

    @Override
    public Double read(ValueSource in) throws IOException {
        return switch (range) {
            case ANY -> in.number();
            case CLOSED -> in.numberFrom(least, most);
            case ABOVE -> in.numberAbove(least, most);
        };
    }

    @Override
    public void write(Double value, ValueSink out) throws IOException {
        out.number(value);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        out.text("type", "number");
        if (range == IncludedEnds.ABOVE) out.number("exclusiveMinimum", least);
        if (range == IncludedEnds.CLOSED) out.number("minimum", least);
        if (range != IncludedEnds.ANY) out.number("maximum", most);
        out.endObject();
    }
}
