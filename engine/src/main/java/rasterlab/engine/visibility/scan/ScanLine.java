package rasterlab.engine.visibility.scan;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FaceBrush;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.VisibilityWork;

/**
 * Row after row: of the faces that cross a row, each boundary of one is where another may become
 * seen; between two boundaries {@link SpanContest} tells which is.
 *
 * <p>An edge becomes active in the row after its upper end and is dropped at its lower one. Its
 * crossing is not summed up from row to row, as the books have it, but computed from its upper end,
 * so that every method owns the same pixels.
 *
 * <p>Sources: C. Wylie, G. Romney, D. Evans, A. Erdahl, Half-tone perspective drawings by computer,
 * AFIPS 1967, pp. 49–58; G. S. Watkins, A real time visible surface algorithm, PhD thesis,
 * University of Utah, 1970.
 */
public final class ScanLine implements SteppedVisibility {
    @Override
    public String decision() {
        return "nearness at the span's first pixel: ρ/z in perspective, −z in parallel projection";
    }

    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        return new Walk(view, paint, out);
    }

    private static final class Walk implements VisibilityWalk {
        private final ScreenFaces faces;
        private final Tally tally = new Tally();
        private final FaceBrush brush;
        private final ActiveEdges edges;
        private final RowSweep sweep;
        private final SpanList ready = new SpanList();
        private final int height;
        private int row = -1;
        private int next;

        Walk(ViewedMesh view, FacePaint paint, Raster out) {
            faces = new ScreenFaces(view, paint);
            brush = new FaceBrush(paint, out, tally);
            height = out.height();
            edges = new ActiveEdges(faces, height);
            sweep = new RowSweep(faces, out.width(), tally);
        }

        @Override
        public boolean advance() {
            while (next == ready.size()) {
                if (++row >= height) return false;
                edges.enter(row);
                ready.clear();
                next = 0;
                sweep.sweep(row, edges, ready);
            }
            int place = ready.place(next);
            brush.span(faces.face(place), row, ready.from(next), ready.to(next));
            next++;
            return true;
        }

        @Override
        public VisibilityStep step() {
            int place = ready.place(next - 1);
            int from = ready.from(next - 1);
            return new VisibilityStep.SpanSeen(
                    faces.face(place),
                    row,
                    from,
                    ready.to(next - 1),
                    faces.nearness(place, from, row));
        }

        @Override
        public VisibilityWork work() {
            return tally.work();
        }
    }
}
