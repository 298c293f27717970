package rasterlab.app.canvas.widget;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * One line of live mathematics: words, numbers and matrices side by side.
 *
 * @param parts from left to right
 */
public record Formula(List<FormulaPart> parts) {
    public Formula {
        parts = List.copyOf(parts);
    }

    public static Formula of(FormulaPart... parts) {
        return new Formula(List.of(parts));
    }

    /** Something that stands in the line. */
    public sealed interface FormulaPart {
        /** The formula for assistive technology and as text. */
        String plainText();
    }

    /** Words or a sign, such as {@code T·M =}. */
    public record FormulaWords(String plainText) implements FormulaPart {}

    /**
     * A matrix in square brackets.
     *
     * @param heads above the brackets, one for each column; none where they are empty
     * @param cells row by row, all rows equally long
     */
    public record Matrix(List<String> heads, List<List<String>> cells) implements FormulaPart {
        public Matrix {
            heads = List.copyOf(heads);
            cells = cells.stream().map(List::copyOf).toList();
            requireRows(cells);
            if (!heads.isEmpty() && heads.size() != cells.get(0).size())
                throw new IllegalArgumentException(
                        "matrix needs a head for each column, got " + heads + " over " + cells);
        }

        public Matrix(List<List<String>> cells) {
            this(List.of(), cells);
        }

        private static void requireRows(List<List<String>> cells) {
            if (cells.isEmpty() || cells.stream().anyMatch(row -> row.size() != width(cells)))
                throw new IllegalArgumentException("matrix needs rows of one length, got " + cells);
        }

        private static int width(List<List<String>> cells) {
            return Math.max(1, cells.get(0).size());
        }

        public static Matrix row(Stream<String> cells) {
            return new Matrix(List.of(cells.toList()));
        }

        int columns() {
            return width(cells);
        }

        @Override
        public String plainText() {
            String above = heads.isEmpty() ? "" : String.join(" ", heads) + ": ";
            return cells.stream()
                    .map(row -> String.join(" ", row))
                    .collect(Collectors.joining("; ", above + "[", "]"));
        }
    }

    /** The whole line as text. */
    public String plainText() {
        return parts.stream().map(FormulaPart::plainText).collect(Collectors.joining(" "));
    }
}
