package rasterlab.engine.visibility.scan;

import java.util.Arrays;
import rasterlab.engine.visibility.Tally;

/** One row from left to right: at each boundary of a face the list of active ones changes. */
final class RowSweep {
    private final int width;
    private final Tally tally;
    private final SpanContest contest;

    /** Places of faces by where they begin: first column in the upper half, place in the lower. */
    private final long[] begins;

    private final int[] end;
    private final int[] active;

    RowSweep(ScreenFaces faces, int width, Tally tally) {
        this.width = width;
        this.tally = tally;
        contest = new SpanContest(faces, tally);
        begins = new long[faces.count()];
        end = new int[faces.count()];
        active = new int[faces.count()];
    }

    void sweep(int row, ActiveEdges edges, SpanList out) {
        int count = sortedBegins(edges);
        int actives = 0;
        int x = 0;
        for (int i = 0; i < count || actives > 0; ) {
            if (actives == 0) x = (int) (begins[i] >>> 32);
            for (; i < count && begins[i] >>> 32 == x; i++) active[actives++] = (int) begins[i];
            int next = i < count ? (int) (begins[i] >>> 32) : width;
            contest.clear();
            for (int k = 0; k < actives; k++) {
                contest.add(active[k]);
                next = Math.min(next, end[active[k]]);
            }
            tally.comparisons += actives;
            contest.resolve(row, x, next, out);
            x = next;
            int kept = 0;
            for (int k = 0; k < actives; k++) if (end[active[k]] > x) active[kept++] = active[k];
            actives = kept;
        }
    }

    private int sortedBegins(ActiveEdges edges) {
        int count = 0;
        for (int i = 0; i < edges.crossedCount(); i++) {
            int place = edges.crossed(i);
            int from = edges.from(place);
            end[place] = edges.to(place, width);
            if (from < end[place]) begins[count++] = (long) from << 32 | place;
        }
        Arrays.sort(begins, 0, count);
        return count;
    }
}
