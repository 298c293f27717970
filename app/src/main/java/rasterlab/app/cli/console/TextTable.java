package rasterlab.app.cli.console;

import java.util.ArrayList;
import java.util.List;

/** Rows of words in aligned columns: text to the left, numbers to the right. */
public final class TextTable {
    private final List<List<String>> rows = new ArrayList<>();

    public TextTable(String... heads) {
        this(List.of(heads));
    }

    public TextTable(List<String> heads) {
        rows.add(List.copyOf(heads));
    }

    /** Adds a row with one cell for each head. */
    public void add(List<String> cells) {
        if (cells.size() != rows.get(0).size())
            throw new IllegalArgumentException(
                    "row needs " + rows.get(0).size() + " cells, got " + cells);
        rows.add(List.copyOf(cells));
    }

    /** One string per row, the heads first. */
    public List<String> lines() {
        return rows.stream().map(this::line).toList();
    }

    private String line(List<String> cells) {
        var line = new StringBuilder();
        for (int column = 0; column < cells.size(); column++) {
            String gap = " ".repeat(width(column) - cells.get(column).length());
            String cell = cells.get(column);
            line.append(numeric(column) ? gap + cell : cell + gap).append("  ");
        }
        return line.toString().stripTrailing();
    }

    private int width(int column) {
        return rows.stream().mapToInt(row -> row.get(column).length()).max().orElse(0);
    }

    private boolean numeric(int column) {
        return rows.size() > 1
                && rows.stream().skip(1).allMatch(row -> row.get(column).matches("[-+0-9.,–eE ]*"));
    }
}
