package rasterlab.engine.transform.matrix;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.ValueSource;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Named matrices from outside: {@code name} and its parameters; {@code matrix} out. */
public final class MatrixFormat extends Format<MatrixFormula, MatrixCall, double[][]> {
    static final Field<String> NAME =
            Field.required(
                    "name",
                    Shape.word(NamedMatrices.all().stream().map(NamedMatrix::name).toList()));

    /** Every parameter that any matrix has; a name means the same number of numbers everywhere. */
    private static final Map<String, Field<double[]>> PARAMETERS = parameters();

    private static final Field<?> MATRIX =
            Field.required("matrix", Shape.list(Shape.numbersOrNull(3, 4)));

    MatrixFormat(Topic<MatrixFormula, MatrixCall, double[][]> topic) {
        super(topic);
    }

    private static Map<String, Field<double[]>> parameters() {
        var fields = new LinkedHashMap<String, Field<double[]>>();
        for (NamedMatrix matrix : NamedMatrices.all())
            for (MatrixParameter parameter : matrix.parameters())
                fields.put(
                        parameter.name(),
                        Field.optional(
                                parameter.name(),
                                parameter.size() == 1
                                        ? new OneNumber()
                                        : Shape.numbers(parameter.size(), parameter.size())));
        return Collections.unmodifiableMap(fields);
    }

    /** A number alone. */
    private record OneNumber() implements Shape<double[]> {
        @Override
        public double[] read(ValueSource in) throws IOException {
            return new double[] {in.number()};
        }

        @Override
        public void write(double[] one, ValueSink out) throws IOException {
            out.number(one[0]);
        }

        @Override
        public void schema(ValueSink out) throws IOException {
            Shape.number().schema(out);
        }
    }

    /** The fields that a matrix by its name may have. */
    static List<Field<?>> fields() {
        var fields = new ArrayList<Field<?>>(PARAMETERS.values());
        fields.add(0, NAME);
        return fields;
    }

    @Override
    public List<Field<?>> input() {
        return fields();
    }

    @Override
    public List<List<Field<?>>> forms() {
        return NamedMatrices.all().stream().map(MatrixFormat::form).toList();
    }

    /** The name of that matrix, and its parameters. */
    private static List<Field<?>> form(NamedMatrix matrix) {
        var fields = new ArrayList<Field<?>>();
        fields.add(Field.required(NAME.name(), Shape.word(List.of(matrix.name()))));
        for (MatrixParameter parameter : matrix.parameters()) {
            Field<double[]> field = PARAMETERS.get(parameter.name());
            fields.add(
                    parameter.otherwise().isPresent()
                            ? field
                            : Field.required(field.name(), field.shape()));
        }
        return fields;
    }

    /** A matrix by its name. */
    public static Shape<MatrixCall> shape() {
        return new MatrixCallShape();
    }

    /**
     * Reads a matrix by its name and makes it, which may refuse parameters that do not go together.
     */
    public static double[][] rows(ValueSource in) throws IOException {
        Given given = in.openObject(fields());
        MatrixCall call = call(given);
        try {
            return NamedMatrices.named(call.name()).rows(call.parameters());
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    protected void writeInputSchema(ValueSink out) throws IOException {
        MatrixCallShape.writeSchema(out);
    }

    @Override
    public boolean open() {
        return true;
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(MATRIX);
    }

    @Override
    public boolean hasSteps() {
        return false;
    }

    @Override
    public String reads() {
        return """
            {"name":"ROT3DX", "angle":30}, the names being listed below""";
    }

    @Override
    public String answers() {
        return """
            {"matrix":[[...],...]} row by row, for points as rows""";
    }

    @Override
    public MatrixCall read(Given given) {
        return call(given);
    }

    @Override
    protected Given given(MatrixCall call) {
        return given(call.name(), call.parameters());
    }

    static Given given(String name, double[] numbers) {
        Given given = new Given().with(NAME, name);
        int next = 0;
        for (MatrixParameter parameter : NamedMatrices.named(name).parameters()) {
            double[] own = Arrays.copyOfRange(numbers, next, next + parameter.size());
            given.with(PARAMETERS.get(parameter.name()), own);
            next += parameter.size();
        }
        return given;
    }

    /** The matrix that the fields ask for, each parameter in its range. */
    static MatrixCall call(Given given) {
        NamedMatrix matrix = NamedMatrices.named(given.get(NAME));
        requireOwn(given, matrix);
        var numbers = new ArrayList<Double>();
        for (MatrixParameter parameter : matrix.parameters()) {
            double[] values =
                    given.find(PARAMETERS.get(parameter.name()))
                            .orElseGet(() -> otherwise(given, parameter));
            for (int i = 0; i < values.length; i++) {
                require(given, parameter, values[i], i);
                numbers.add(values[i]);
            }
        }
        return new MatrixCall(matrix.name(), numbers);
    }

    private static void requireOwn(Given given, NamedMatrix matrix) {
        List<String> own = matrix.parameters().stream().map(MatrixParameter::name).toList();
        for (String field :
                Stream.concat(given.unknown().stream(), given.names().stream().sorted()).toList())
            if (!field.equals(NAME.name()) && !own.contains(field))
                throw given.invalid(
                        field,
                        matrix.name()
                                + " has no such parameter; "
                                + (own.isEmpty()
                                        ? "it has none"
                                        : "allowed are " + String.join(", ", own)));
    }

    private static double[] otherwise(Given given, MatrixParameter parameter) {
        return new double[] {
            parameter
                    .otherwise()
                    .orElseThrow(
                            () ->
                                    given.invalid(
                                            parameter.name(),
                                            "missing; expected " + parameter.words()))
        };
    }

    private static void require(Given given, MatrixParameter parameter, double value, int i) {
        try {
            parameter.require(value, i);
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    public void write(MatrixCall input, double[][] rows, ValueSink out) throws IOException {
        out.name(MATRIX.name());
        out.startArray();
        for (double[] row : rows) out.numbers(row);
        out.endArray();
    }
}
