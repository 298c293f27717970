package rasterlab.engine.transform.exact;

import java.math.BigDecimal;

/** A square matrix of many digits, for row points. */
public record BigMatrix(BigDecimal[][] rows) {
    /** The matrix of these numbers, row by row. */
    public static BigMatrix of(int size, Object... cells) {
        var rows = new BigDecimal[size][size];
        for (int i = 0; i < size * size; i++) rows[i / size][i % size] = big(cells[i]);
        return new BigMatrix(rows);
    }

    /** The matrix of these numbers, row by row. */
    public static BigMatrix of(int size, double[] cells) {
        var rows = new BigDecimal[size][size];
        for (int i = 0; i < cells.length; i++) rows[i / size][i % size] = new BigDecimal(cells[i]);
        return new BigMatrix(rows);
    }

    public static BigMatrix identity(int size) {
        var rows = new BigDecimal[size][size];
        for (int i = 0; i < size * size; i++)
            rows[i / size][i % size] = i / size == i % size ? BigDecimal.ONE : BigDecimal.ZERO;
        return new BigMatrix(rows);
    }

    private static BigDecimal big(Object cell) {
        if (cell instanceof BigDecimal decimal) return decimal;
        if (cell instanceof Integer whole) return BigDecimal.valueOf(whole);
        return new BigDecimal((Double) cell);
    }

    /** This one first, then {@code next}: the product in the textbook's order. */
    public BigMatrix then(BigMatrix next) {
        var product = new BigDecimal[rows.length][];
        for (int i = 0; i < rows.length; i++) product[i] = next.image(rows[i]);
        return new BigMatrix(product);
    }

    /** The row {@code row · M}; sums are exact, so that cancellation loses nothing. */
    public BigDecimal[] image(BigDecimal[] row) {
        var image = new BigDecimal[row.length];
        for (int j = 0; j < row.length; j++) {
            BigDecimal sum = BigDecimal.ZERO;
            for (int k = 0; k < row.length; k++) sum = sum.add(row[k].multiply(rows[k][j]));
            image[j] = sum;
        }
        return image;
    }

    /** Each cell as the nearest double. */
    public double[][] toDoubles() {
        var doubles = new double[rows.length][rows.length];
        for (int i = 0; i < rows.length; i++)
            for (int j = 0; j < rows.length; j++) doubles[i][j] = rows[i][j].doubleValue();
        return doubles;
    }
}
