package rasterlab.app.cli.run;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.MatrixParameter;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;

/** A named matrix as JSON: {@code name} and its parameters by their names. */
final class MatrixJson {
    private static final JsonField<String> NAME =
            JsonField.required(
                    "name",
                    json ->
                            json.word(
                                    NamedMatrices.all().stream().map(NamedMatrix::name).toList()));

    /** Every parameter that any matrix has; a name means the same number of numbers everywhere. */
    private static final Map<String, JsonField<double[]>> PARAMETERS = parameters();

    private MatrixJson() {}

    private static Map<String, JsonField<double[]>> parameters() {
        var fields = new LinkedHashMap<String, JsonField<double[]>>();
        for (NamedMatrix matrix : NamedMatrices.all())
            for (MatrixParameter parameter : matrix.parameters())
                fields.put(parameter.name(), JsonField.optional(parameter.name(), read(parameter)));
        return Collections.unmodifiableMap(fields);
    }

    private static JsonField.Reader<double[]> read(MatrixParameter parameter) {
        return parameter.size() == 1
                ? json -> new double[] {json.number()}
                : json -> json.numbers(parameter.size(), parameter.size());
    }

    /** The fields that an object may have. */
    static JsonField<?>[] fields() {
        var fields = new ArrayList<JsonField<?>>(PARAMETERS.values());
        fields.add(0, NAME);
        return fields.toArray(JsonField<?>[]::new);
    }

    /** Reads an object inside the input. */
    static MatrixCall read(StrictJson json) throws IOException {
        return call(json.openObject(fields()));
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
                throw given.complaint(
                        field,
                        matrix.name()
                                + " has no such parameter; "
                                + (own.isEmpty()
                                        ? "it has none"
                                        : "allowed are " + String.join(", ", own)));
    }

    private static double[] otherwise(Given given, MatrixParameter parameter) {
        return new double[] {
            parameter.otherwise().orElseThrow(() -> given.complaint(parameter.name(), "missing"))
        };
    }

    private static void require(Given given, MatrixParameter parameter, double value, int i) {
        try {
            parameter.require(value, i);
        } catch (IllegalArgumentException e) {
            throw given.complaint(parameter.name(), e.getMessage());
        }
    }
}
