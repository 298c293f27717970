package rasterlab.engine.transform.matrix;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import rasterlab.engine.range.Bounds;

/**
 * A matrix that the course has a name for.
 *
 * @param name upper-case
 * @param parameters in the order of their numbers
 * @param meaning one English sentence
 * @param inverse its inverse
 * @param size 3 or 4
 * @param cells all cells row by row, from numbers that are in range
 */
public record NamedMatrix(
        String name,
        List<MatrixParameter> parameters,
        String meaning,
        MatrixInverse inverse,
        int size,
        Function<double[], double[]> cells) {
    public NamedMatrix {
        Bounds.require("size", size, 3, 4);
        parameters = List.copyOf(parameters);
    }

    static NamedMatrix space(
            String name,
            String meaning,
            MatrixInverse inverse,
            Function<double[], Matrix4d> formula,
            MatrixParameter... parameters) {
        return new NamedMatrix(
                name,
                List.of(parameters),
                meaning,
                inverse,
                4,
                numbers -> formula.apply(numbers).get(new double[16]));
    }

    static NamedMatrix plane(
            String name,
            String meaning,
            MatrixInverse inverse,
            Function<double[], Matrix3d> formula,
            MatrixParameter... parameters) {
        return new NamedMatrix(
                name,
                List.of(parameters),
                meaning,
                inverse,
                3,
                numbers -> formula.apply(numbers).get(new double[9]));
    }

    /** Name and parameters as they are written: {@code ROTAXIS(through, direction, angle)}. */
    public String usage() {
        if (parameters.isEmpty()) return name;
        return parameters.stream()
                .map(MatrixParameter::name)
                .collect(Collectors.joining(", ", name + "(", ")"));
    }

    /** How many numbers all parameters are together. */
    public int numbers() {
        return parameters.stream().mapToInt(MatrixParameter::size).sum();
    }

    /**
     * Passes if each parameter is in its range.
     *
     * @throws IllegalArgumentException naming the parameter, its value and the range
     */
    public void require(double... numbers) {
        if (numbers.length != numbers())
            throw new IllegalArgumentException(
                    usage() + " takes " + numbers() + " numbers, got " + numbers.length);
        int next = 0;
        for (MatrixParameter parameter : parameters)
            for (int i = 0; i < parameter.size(); i++) parameter.require(numbers[next++], i);
    }

    /**
     * The matrix.
     *
     * @throws IllegalArgumentException if a parameter is out of range or a cell too large
     */
    public double[][] rows(double... numbers) {
        require(numbers);
        double[] all = cells.apply(numbers);
        var rows = new double[size][size];
        for (int i = 0; i < all.length; i++) {
            if (!Double.isFinite(all[i]))
                throw new IllegalArgumentException(
                        "%s: row %d, column %d is too large for a double, its parameters being too large or too close to each other"
                                .formatted(name, i / size + 1, i % size + 1));
            rows[i / size][i % size] = all[i] + 0.0; // −0 becomes 0
        }
        return rows;
    }

    /**
     * The inverse for the same parameters; empty where there is none.
     *
     * @throws IllegalArgumentException as {@link #rows} does for parameters out of range
     */
    public Optional<double[][]> inverseRows(double... numbers) {
        require(numbers);
        return inverse.cells().map(formula -> formula.apply(numbers)).flatMap(this::finiteRows);
    }

    private Optional<double[][]> finiteRows(double[] all) {
        if (!Arrays.stream(all).allMatch(Double::isFinite)) return Optional.empty();
        var rows = new double[size][];
        for (int i = 0; i < size; i++) rows[i] = Arrays.copyOfRange(all, i * size, (i + 1) * size);
        return Optional.of(rows);
    }
}
