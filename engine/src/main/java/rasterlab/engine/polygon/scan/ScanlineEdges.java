package rasterlab.engine.polygon.scan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The edges that cross one row, kept from row to row: an edge enters at its first row and leaves
 * after its last one.
 */
final class ScanlineEdges {
    private final List<PolygonEdge> waiting;
    private final List<PolygonEdge> active = new ArrayList<>();
    private final int height;
    private int entered;
    private int row = -1;

    /**
     * @param edges those that cross a row of the picture
     */
    ScanlineEdges(List<PolygonEdge> edges, int height) {
        waiting = new ArrayList<>(edges);
        waiting.sort(Comparator.comparingInt(PolygonEdge::firstRow));
        this.height = height;
    }

    /** Goes down to the next row that some edge crosses; false when there is none. */
    boolean nextRow() {
        row++;
        active.removeIf(edge -> edge.endRow(height) <= row);
        if (active.isEmpty()) {
            if (entered == waiting.size()) return false;
            row = waiting.get(entered).firstRow();
        }
        while (entered < waiting.size() && waiting.get(entered).firstRow() <= row)
            active.add(waiting.get(entered++));
        return true;
    }

    int row() {
        return row;
    }

    int size() {
        return active.size();
    }

    PolygonEdge edge(int index) {
        return active.get(index);
    }

    /** Where the row crosses the active edges, from left to right. */
    List<RowCrossing> crossings(int width) {
        return active.stream()
                .map(edge -> edge.crossing(row, width))
                .sorted(
                        Comparator.comparingInt(RowCrossing::column)
                                .thenComparingDouble(RowCrossing::x))
                .toList();
    }
}
