package rasterlab.engine.transform.matrix;

import java.util.Arrays;
import java.util.List;

/**
 * A matrix asked for by name.
 *
 * @param name of one of {@link NamedMatrices#all}
 * @param numbers its parameters' numbers in order
 */
public record MatrixCall(String name, List<Double> numbers) {
    public MatrixCall {
        numbers = List.copyOf(numbers);
    }

    public static MatrixCall of(String name, double... numbers) {
        return new MatrixCall(name, Arrays.stream(numbers).boxed().toList());
    }

    double[] parameters() {
        return numbers.stream().mapToDouble(Double::doubleValue).toArray();
    }
}
