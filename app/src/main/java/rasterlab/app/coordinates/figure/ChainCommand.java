package rasterlab.app.coordinates.figure;

import java.util.List;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.engine.format.Written;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.MatrixParameter;
import rasterlab.engine.transform.matrix.NamedMatrices;

/** The shell command that applies matrices to points, matrices by their names among them. */
public final class ChainCommand {
    private ChainCommand() {}

    /**
     * Writes the command.
     *
     * @param matrices in the order in which they are applied
     * @param points of as many numbers each as {@code dimension}
     */
    public static String of(List<Written> matrices, int dimension, double[] points, String method) {
        String input =
                CommandInput.of(
                        out -> {
                            out.name("matrices");
                            out.startArray();
                            for (Written matrix : matrices) matrix.write(out);
                            out.endArray();
                            out.points("points", points, dimension);
                        });
        return "echo '%s' | ./lab run transform %s".formatted(input, method);
    }

    /** A matrix by its name, as {@code {"name": "ROT3DX", "angle": 30}} with its own parameters. */
    public static Written named(MatrixCall call) {
        return out -> {
            out.startObject();
            out.text("name", call.name());
            int next = 0;
            for (MatrixParameter parameter : NamedMatrices.named(call.name()).parameters()) {
                double[] own = numbers(call, next, parameter.size());
                next += parameter.size();
                if (own.length == 1) out.number(parameter.name(), own[0]);
                else out.numbers(parameter.name(), own);
            }
            out.endObject();
        };
    }

    private static double[] numbers(MatrixCall call, int from, int size) {
        return call.numbers().subList(from, from + size).stream()
                .mapToDouble(Double::doubleValue)
                .toArray();
    }

    /** A matrix by its cells, row by row. */
    public static Written cells(int size, double[] cells) {
        return out -> out.points(cells, size);
    }
}
