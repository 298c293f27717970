package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.coordinates.figure.Chains;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.NamedMatrices;

/**
 * One matrix of a list: by its name, or by all of its cells.
 *
 * @param name of the course, or {@link #FREE}
 * @param numbers its parameters, or its cells row by row
 */
public record ListItem(String name, List<Double> numbers) {
    /** A matrix whose cells are all typed. */
    public static final String FREE = "MATRIX";

    public ListItem {
        numbers = List.copyOf(numbers);
    }

    public static ListItem of(String name, double... numbers) {
        var list = new ArrayList<Double>();
        for (double number : numbers) list.add(number);
        return new ListItem(name, list);
    }

    static ListItem of(MatrixCall call) {
        return new ListItem(call.name(), call.numbers());
    }

    /** An item with the numbers that show best what the matrix does. */
    static ListItem first(String name, int dimension) {
        return of(name, FirstNumbers.of(name, dimension));
    }

    boolean free() {
        return name.equals(FREE);
    }

    /** 2 for a matrix of the plane, 3 for one of space. */
    int dimension() {
        if (free()) return numbers.size() == 9 ? 2 : 3;
        return NamedMatrices.named(name).size() - 1;
    }

    MatrixCall call() {
        return new MatrixCall(name, numbers);
    }

    ListItem with(int index, double value) {
        var changed = new ArrayList<>(numbers);
        changed.set(index, value);
        return new ListItem(name, changed);
    }

    /**
     * The cells row by row.
     *
     * @throws IllegalArgumentException if a parameter is out of its range
     */
    double[] cells(MatrixFormula formula) {
        double[] values = numbers.stream().mapToDouble(Double::doubleValue).toArray();
        return free() ? values : Chains.flat(formula.rows(name, values));
    }
}
