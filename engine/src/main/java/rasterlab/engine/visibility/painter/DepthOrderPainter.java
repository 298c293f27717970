package rasterlab.engine.visibility.painter;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.DepthOrder;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FaceBrush;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.VisibilityWork;
import rasterlab.engine.visibility.order.Sight;

/**
 * Paints faces and pieces of them in the order that a method of topic {@code depth-order} gives, in
 * {@link SightSpace}. The method is asked once for a picture.
 *
 * <p>A whole face is filled as every method fills it. A piece is filled by its own corners, as they
 * were given: nothing else is known of it.
 */
public final class DepthOrderPainter implements SteppedVisibility {
    private final DepthOrder method;

    /** A piece as it was given. */
    private record Piece(int polygon, double[] corners) {}

    public DepthOrderPainter(DepthOrder method) {
        this.method = method;
    }

    @Override
    public String decision() {
        return "place in the order, from 1";
    }

    /**
     * @throws IllegalArgumentException with the method's own words, or naming the piece that cannot
     *     be painted
     */
    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        return new Walk(view, paint, out);
    }

    private final class Walk implements PiecesWalk {
        private final ViewedMesh view;
        private final SightSpace space;
        private final double[][] polygons;
        private final List<Piece> pieces = new ArrayList<>();
        private final Tally tally = new Tally();
        private final FaceBrush brush;
        private final ScreenPolygon whole;
        private int painted;

        Walk(ViewedMesh view, FacePaint paint, Raster out) {
            this.view = view;
            space = new SightSpace(view);
            brush = new FaceBrush(paint, out, tally);
            whole = new ScreenPolygon(view);
            Sight sight = space.sight();
            polygons = sight.polygons();
            method.order(sight.polygons(), sight.eye(), this::take);
            tally.splits = Math.max(0, pieces.size() - polygons.length);
        }

        private void take(int polygon, double[] corners) {
            String place = "piece " + pieces.size();
            if (polygon < 0 || polygon >= polygons.length)
                throw new IllegalArgumentException(
                        "%s: polygon must be from 0 to %d, got %d"
                                .formatted(place, polygons.length - 1, polygon));
            if (corners.length < 9 || corners.length % 3 != 0)
                throw new IllegalArgumentException(
                        "%s: corners need 3 numbers each and are at least 3, got %d numbers"
                                .formatted(place, corners.length));
            for (int i = 0; i < corners.length; i++)
                if (!Double.isFinite(corners[i]) || i % 3 == 2 && !(corners[i] > 0))
                    throw new IllegalArgumentException(
                            "%s: corner %d must lie before the eye, got %s = %s"
                                    .formatted(place, i / 3, "xyz".charAt(i % 3), corners[i]));
            pieces.add(new Piece(polygon, corners.clone()));
        }

        @Override
        public boolean advance() {
            if (painted == pieces.size()) return false;
            Piece piece = pieces.get(painted++);
            int face = space.face(piece.polygon());
            Optional<double[]> cut = piece();
            if (cut.isPresent()) brush.fill(ScreenPolygon.ofPixels(cut.get()), face);
            else {
                whole.load(view, face);
                brush.fill(whole, face);
            }
            return true;
        }

        @Override
        public Optional<double[]> piece() {
            Piece piece = pieces.get(painted - 1);
            boolean given = Arrays.equals(piece.corners(), polygons[piece.polygon()]);
            return given ? Optional.empty() : Optional.of(space.toPixels(piece.corners()));
        }

        @Override
        public VisibilityStep step() {
            int face = space.face(pieces.get(painted - 1).polygon());
            return new VisibilityStep.FaceDrawn(face, painted);
        }

        @Override
        public VisibilityWork work() {
            return tally.work();
        }
    }
}
