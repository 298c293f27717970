package rasterlab.exercises.child;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.contract.PieceSink;
import rasterlab.contract.PolygonSink;

/** Keeps polygons, as they were when they were sent. */
final class PolygonSheet extends SinkSheet implements PolygonSink, PieceSink {
    /** The most numbers that an answer may have, over all polygons of a call. */
    private static final int MOST_NUMBERS = Wire.MOST_FRAME_BYTES / Double.BYTES / 2;

    private record Piece(int polygon, double[] corners) {}

    private final boolean numbered;
    private final int most;
    private final List<Piece> pieces = new ArrayList<>();
    private int numbers;

    /**
     * @param numbered whether each tells which polygon it is a piece of
     * @param limit the most polygons
     */
    PolygonSheet(boolean numbered, int limit) {
        this.numbered = numbered;
        this.most = limit;
    }

    @Override
    public void polygon(double[] corners) {
        keep(0, corners);
    }

    @Override
    public void piece(int polygon, double[] corners) {
        keep(polygon, corners);
    }

    private void keep(int polygon, double[] corners) {
        if (pieces.size() == most || corners.length > MOST_NUMBERS - numbers) stop();
        numbers += corners.length;
        pieces.add(new Piece(polygon, corners.clone()));
    }

    @Override
    void writeTo(DataOutputStream out) throws IOException {
        out.writeInt(pieces.size());
        for (Piece piece : pieces) {
            if (numbered) out.writeInt(piece.polygon());
            Values.write(double[].class, piece.corners(), out);
        }
    }

    @Override
    void addTo(ItemSum sum) {
        for (Piece piece : pieces) {
            long[] bits = new long[piece.corners().length + 1];
            Arrays.setAll(
                    bits,
                    i ->
                            i == 0
                                    ? piece.polygon()
                                    : Double.doubleToLongBits(piece.corners()[i - 1]));
            sum.add(bits);
        }
    }
}
