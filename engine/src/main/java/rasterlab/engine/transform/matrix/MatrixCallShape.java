package rasterlab.engine.transform.matrix;

import java.io.IOException;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.ValueSource;

/** A matrix by its name, with the parameters that this name has. */
final class MatrixCallShape implements Shape<MatrixCall> {
    @Override
    public MatrixCall read(ValueSource in) throws IOException {
        return MatrixFormat.call(in.openObject(MatrixFormat.fields()));
    }

    @Override
    public void write(MatrixCall call, ValueSink out) throws IOException {
        out.startObject();
        MatrixFormat.given(call.name(), call.parameters()).write(MatrixFormat.fields(), out);
        out.endObject();
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        writeSchema(out);
        out.endObject();
    }

    /** Writes one schema for each name. */
    static void writeSchema(ValueSink out) throws IOException {
        out.name("anyOf");
        out.startArray();
        for (NamedMatrix matrix : NamedMatrices.all()) {
            out.startObject();
            write(matrix, out);
            out.endObject();
        }
        out.endArray();
    }

    private static void write(NamedMatrix matrix, ValueSink out) throws IOException {
        out.text("type", "object");
        out.name("properties");
        out.startObject();
        out.name(MatrixFormat.NAME.name());
        out.startObject();
        out.text("const", matrix.name());
        out.endObject();
        for (MatrixParameter parameter : matrix.parameters()) {
            out.name(parameter.name());
            write(parameter, out);
        }
        out.endObject();
        out.name("required");
        out.startArray();
        out.text(MatrixFormat.NAME.name());
        for (MatrixParameter parameter : matrix.parameters())
            if (parameter.otherwise().isEmpty()) out.text(parameter.name());
        out.endArray();
        out.flag("additionalProperties", false);
    }

    private static void write(MatrixParameter parameter, ValueSink out) throws IOException {
        out.startObject();
        if (parameter.size() > 1) {
            out.text("type", "array");
            out.whole("minItems", parameter.size());
            out.whole("maxItems", parameter.size());
            out.name("items");
            out.startObject();
        }
        out.text("type", "number");
        parameter.range().writeSchema(out);
        if (parameter.size() > 1) out.endObject();
        out.endObject();
    }
}
