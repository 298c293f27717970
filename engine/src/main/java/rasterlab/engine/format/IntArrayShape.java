package rasterlab.engine.format;

import java.io.IOException;

/** An array of exactly {@code count} whole numbers in the range of int. */
record IntArrayShape(int count) implements Shape<int[]> {
    @Override
    public int[] read(ValueSource in) throws IOException {
        return in.wholes(count);
    }

    @Override
    public void write(int[] value, ValueSink out) throws IOException {
        out.wholes(value);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        var any = new WholeShape(Integer.MIN_VALUE, Integer.MAX_VALUE);
        ArraySchema.write(out, any, count, count);
    }
}
