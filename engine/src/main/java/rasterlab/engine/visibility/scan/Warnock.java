package rasterlab.engine.visibility.scan;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FaceBrush;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.RowSpan;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.VisibilityWork;

/**
 * Windows: one in which nothing or a single face is to be seen is painted, any other is cut in four
 * and each part looked at likewise, down to one pixel.
 *
 * <p>A face is disjoint from a window, contained in it, surrounds it or intersects it. Disjoint
 * ones are left out, and so are those that an opaque surrounding face hides: as nearness is linear,
 * it is nearer in the whole window if it is in the four corners.
 *
 * <p>Source: J. E. Warnock, A hidden surface algorithm for computer generated halftone pictures,
 * PhD thesis, University of Utah, 1969.
 */
public final class Warnock implements SteppedVisibility {
    @Override
    public String decision() {
        return "faces that are neither disjoint from the window nor hidden in all of it";
    }

    @Override
    public VisibilityWalk walk(ViewedMesh view, FacePaint paint, Raster out) {
        return new Walk(view, paint, out);
    }

    /**
     * Pixels [x, x + width) × [y, y + height).
     *
     * @param candidates places of the faces that were left in the window it is a part of
     */
    private record Part(int x, int y, int width, int height, int[] candidates) {}

    private static final class Walk implements VisibilityWalk {
        private final ScreenFaces faces;
        private final WindowFaces window;
        private final SpanContest contest;
        private final Tally tally = new Tally();
        private final FaceBrush brush;
        private final SpanList ready = new SpanList();
        private final RowSpan span = new RowSpan();
        private final Deque<Part> undone = new ArrayDeque<>();
        private VisibilityStep step;

        Walk(ViewedMesh view, FacePaint paint, Raster out) {
            faces = new ScreenFaces(view, paint);
            window = new WindowFaces(faces, tally);
            contest = new SpanContest(faces, tally);
            brush = new FaceBrush(paint, out, tally);
            var all = new int[faces.count()];
            Arrays.setAll(all, place -> place);
            undone.push(new Part(0, 0, out.width(), out.height(), all));
        }

        @Override
        public boolean advance() {
            if (undone.isEmpty()) return false;
            Part part = undone.pop();
            int[] left = window.left(part.x, part.y, part.width, part.height, part.candidates);
            boolean divide = left.length > 1 && (part.width > 1 || part.height > 1);
            if (divide) divide(part, left);
            else if (left.length == 1) paint(part, left[0]);
            else if (left.length > 1) paintPixel(part, left);
            step =
                    new VisibilityStep.Window(
                            part.x, part.y, part.width, part.height, divide, left.length);
            return true;
        }

        private void divide(Part part, int[] left) {
            tally.splits++;
            int wide = (part.width + 1) / 2;
            int high = (part.height + 1) / 2;
            for (int j = 1; j >= 0; j--)
                for (int i = 1; i >= 0; i--) {
                    int width = i == 0 ? wide : part.width - wide;
                    int height = j == 0 ? high : part.height - high;
                    if (width == 0 || height == 0) continue;
                    undone.push(
                            new Part(part.x + i * wide, part.y + j * high, width, height, left));
                }
        }

        private void paint(Part part, int place) {
            for (int row = part.y; row < part.y + part.height; row++) {
                faces.load(place, row, span);
                int from = span.from(part.x);
                int to = span.to(part.x + part.width);
                if (from < to) brush.span(faces.face(place), row, from, to);
            }
        }

        private void paintPixel(Part part, int[] left) {
            contest.clear();
            for (int place : left) contest.add(place);
            ready.clear();
            contest.resolve(part.y, part.x, part.x + 1, ready);
            for (int i = 0; i < ready.size(); i++)
                brush.span(faces.face(ready.place(i)), part.y, part.x, part.x + 1);
        }

        @Override
        public VisibilityStep step() {
            return step;
        }

        @Override
        public VisibilityWork work() {
            return tally.work();
        }
    }
}
