package rasterlab.app.coordinates.figure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.MatrixParameter;
import rasterlab.engine.transform.matrix.NamedMatrices;

/** Matrices and points as the command line reads them. */
public final class CallJson {
    private CallJson() {}

    /** {@code {"name":"ROT3DX", "angle":30}}. */
    public static String call(MatrixCall call) {
        var json = new StringBuilder("{\"name\": \"" + call.name() + "\"");
        int next = 0;
        for (MatrixParameter parameter : NamedMatrices.named(call.name()).parameters()) {
            List<Double> numbers = call.numbers().subList(next, next + parameter.size());
            next += parameter.size();
            json.append(", \"").append(parameter.name()).append("\": ");
            json.append(parameter.size() == 1 ? number(numbers.get(0)) : list(numbers));
        }
        return json.append('}').toString();
    }

    /** {@code [[x, y, z], …]}. */
    public static String points(int dimension, double[] numbers) {
        return rows(dimension, numbers);
    }

    /** Numbers in rows of so many. */
    public static String rows(int length, double[] numbers) {
        var rows = new ArrayList<String>();
        for (int i = 0; i < numbers.length; i += length)
            rows.add(
                    list(
                            Arrays.stream(numbers, i, i + length)
                                    .boxed()
                                    .collect(Collectors.toList())));
        return rows.stream().collect(Collectors.joining(", ", "[", "]"));
    }

    private static String list(List<Double> numbers) {
        return numbers.stream().map(CallJson::number).collect(Collectors.joining(", ", "[", "]"));
    }

    /** All digits that the number has, a whole one without ".0". */
    private static String number(double value) {
        String digits = Double.toString(value + 0.0);
        return digits.endsWith(".0") ? digits.substring(0, digits.length() - 2) : digits;
    }
}
