package rasterlab.engine.scene.shape;

import java.util.ArrayList;
import java.util.List;

/**
 * Puts the faces of one patch together where blocks of its cells are joined.
 *
 * <p>A block keeps all corners on the sides that it shares with cells that are not joined, and on
 * the ends of the patch, so that no gap opens there: it becomes a fan of triangles about its
 * middle. A block among joined ones is one face.
 */
final class BlockFaces {
    private final FaceGrid grid;
    private final int number;
    private final JoinedBlocks blocks;
    private final Patch patch;
    private final int steps;
    private final int rows;

    /**
     * @param number of the patch
     */
    BlockFaces(FaceGrid grid, int number, JoinedBlocks blocks) {
        this.grid = grid;
        this.number = number;
        this.blocks = blocks;
        patch = grid.asked().shape().patches().get(number);
        steps = grid.asked().uSteps();
        rows = grid.rows(patch);
    }

    /** Adds all faces of the patch. */
    void add() {
        int side = blocks.side();
        for (int i = 0; i < steps; i += side)
            for (int j = 0; j < rows; j += side) {
                int nextI = Math.min(i + side, steps);
                int nextJ = Math.min(j + side, rows);
                if (blocks.joined(number, i / side, j / side)) addBlock(i, nextI, j, nextJ);
                else grid.addCells(patch, i, nextI, j, nextJ);
            }
    }

    private void addBlock(int fromU, int toU, int fromV, int toV) {
        int column = fromU / blocks.side();
        int row = fromV / blocks.side();
        List<int[]> corners = new ArrayList<>();
        boolean whole = addSide(corners, fromU, fromV, toU, fromV, isJoined(column, row - 1));
        whole &= addSide(corners, toU, fromV, toU, toV, isJoined(column + 1, row));
        whole &= addSide(corners, toU, toV, fromU, toV, isJoined(column, row + 1));
        whole &= addSide(corners, fromU, toV, fromU, fromV, isJoined(column - 1, row));
        if (whole) {
            grid.addFace(patch, fromU, toU, fromV, toV);
            return;
        }
        double u = patch.u().between(fromU, toU, steps);
        double v = patch.v().between(fromV, toV, rows);
        for (int k = 0; k < corners.size(); k++) {
            int[] here = corners.get(k);
            int[] next = corners.get((k + 1) % corners.size());
            boolean point = here[1] == next[1] && patch.isPole(patch.v().at(here[1], rows));
            if (!point) grid.addTriangle(patch, u, v, here, next);
        }
    }

    /**
     * Adds the corners of a side but its last: all steps, or the first alone where the side is one
     * edge, which it answers.
     */
    private boolean addSide(
            List<int[]> corners, int u, int v, int endU, int endV, boolean besideJoined) {
        boolean one = besideJoined || v == endV && patch.isPole(patch.v().at(v, rows));
        int all = Math.abs(endU - u) + Math.abs(endV - v);
        int some = one ? 1 : all;
        for (int k = 0; k < some; k++)
            corners.add(new int[] {u + (endU - u) / all * k, v + (endV - v) / all * k});
        return one || all == 1;
    }

    /** Whether the block beside one is joined; beyond the patch none is. */
    private boolean isJoined(int column, int row) {
        int columns = JoinedBlocks.count(steps, blocks.side());
        int blockRows = JoinedBlocks.count(rows, blocks.side());
        int u = patch.u().round() ? Math.floorMod(column, columns) : column;
        int v = patch.v().round() ? Math.floorMod(row, blockRows) : row;
        return u >= 0 && u < columns && v >= 0 && v < blockRows && blocks.joined(number, u, v);
    }
}
