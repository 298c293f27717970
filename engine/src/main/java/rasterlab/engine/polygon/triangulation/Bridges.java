package rasterlab.engine.polygon.triangulation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.engine.geometry.Orientation;
import rasterlab.engine.polygon.MeetingEdges;

/**
 * The rules for a way round a polygon that goes along some edges twice, once each way: bridges, by
 * which holes and islands are joined to one way.
 *
 * <p>Corners may stand in one place only where a bridge ends. Edges meet at their corners only.
 * Closed ways are left without the bridges, of which no two touch: outsides, gone round the one
 * way, and holes in them, gone round the other. So every point is gone round once or not at all.
 */
final class Bridges {
    private final Corners corners;
    private final Places places;
    private final boolean[] bridge;

    /** The corner of each place where an edge begins that is no bridge; −1 where none does. */
    private final int[] start;

    /**
     * @param places of the corners, some shared
     */
    Bridges(Corners corners, Places places) {
        this.corners = corners;
        this.places = places;
        bridge = new boolean[corners.size()];
        start = new int[places.count()];
    }

    /**
     * Passes if the way keeps the rules.
     *
     * @return whether its outsides are gone round clockwise
     * @throws IllegalArgumentException naming two edges, or what is wrong with the holes
     */
    boolean requireUsable() {
        findBridges();
        requireBridgeEnds();
        findStarts();
        requireMeetingAtCorners();
        return requireHolesInside();
    }

    private int placeAfter(int corner) {
        return places.of(corners.after(corner));
    }

    private void findBridges() {
        Map<Long, Integer> edges = new HashMap<>();
        for (int i = 0; i < corners.size(); i++) {
            Integer before = edges.put(key(places.of(i), placeAfter(i)), i);
            if (before != null) throw meeting(before, i);
        }
        for (int i = 0; i < corners.size(); i++)
            bridge[i] = edges.containsKey(key(placeAfter(i), places.of(i)));
    }

    private static long key(int from, int to) {
        return (long) from << 32 | to;
    }

    private IllegalArgumentException meeting(int one, int other) {
        return corners.meeting(
                new MeetingEdges.EdgePair(Math.min(one, other), Math.max(one, other)));
    }

    private void requireBridgeEnds() {
        for (int i = 0; i < corners.size(); i++) {
            int[] here = places.corners(i);
            if (here.length == 1) continue;
            if (Arrays.stream(here).noneMatch(k -> bridge[k] || bridge[corners.before(k)]))
                throw meeting(here[0], here[1]);
        }
    }

    private void findStarts() {
        Arrays.fill(start, -1);
        for (int i = 0; i < corners.size(); i++) {
            if (bridge[i]) continue;
            int place = places.of(i);
            if (start[place] >= 0) throw meeting(start[place], i);
            start[place] = i;
        }
    }

    private void requireMeetingAtCorners() {
        int[] firsts = places.firsts();
        double[] x = Arrays.stream(firsts).mapToDouble(i -> corners.x[i]).toArray();
        double[] y = Arrays.stream(firsts).mapToDouble(i -> corners.y[i]).toArray();
        int[] once =
                IntStream.range(0, corners.size())
                        .filter(i -> !bridge[i] || places.of(i) < placeAfter(i))
                        .toArray();
        int[] from = Arrays.stream(once).map(places::of).toArray();
        int[] to = Arrays.stream(once).map(this::placeAfter).toArray();
        Optional<MeetingEdges.EdgePair> pair = MeetingEdges.of(x, y, from, to);
        if (pair.isPresent()) throw meeting(once[pair.get().one()], once[pair.get().other()]);
    }

    /** Closed ways without bridges, each as the corners where its edges begin. */
    private List<List<Integer>> ways() {
        List<List<Integer>> ways = new ArrayList<>();
        boolean[] seen = new boolean[places.count()];
        for (int place = 0; place < seen.length; place++) {
            if (start[place] < 0 || seen[place]) continue;
            var way = new ArrayList<Integer>();
            for (int at = place; !seen[at]; at = placeAfter(start[at])) {
                seen[at] = true;
                way.add(start[at]);
            }
            ways.add(way);
        }
        return ways;
    }

    /** Whether the outsides are gone round clockwise. */
    private boolean requireHolesInside() {
        List<List<Integer>> ways = ways();
        if (ways.isEmpty())
            throw new IllegalArgumentException("all edges are gone along both ways: no area");
        int[] leftmost = ways.stream().mapToInt(this::leftmost).toArray();
        int outermost = 0;
        for (int w = 1; w < leftmost.length; w++)
            if (leftOf(leftmost[w], leftmost[outermost])) outermost = w;
        int outside = turn(ways.get(outermost), leftmost[outermost]);
        for (int w = 0; w < leftmost.length; w++) {
            int rounds = 0;
            for (int other = 0; other < leftmost.length; other++)
                if (other != w) rounds += rounds(ways.get(other), leftmost[w]);
            boolean hole = turn(ways.get(w), leftmost[w]) != outside;
            if (rounds != (hole ? outside : 0))
                throw new IllegalArgumentException(
                        "holes must lie inside and be gone round the other way than the outside,"
                                + " but those round corner "
                                + corners.number[leftmost[w]]
                                + " are not");
        }
        return outside < 0;
    }

    private int leftmost(List<Integer> way) {
        int leftmost = way.get(0);
        for (int i : way) if (leftOf(i, leftmost)) leftmost = i;
        return leftmost;
    }

    private boolean leftOf(int i, int j) {
        return corners.x[i] < corners.x[j]
                || corners.x[i] == corners.x[j] && corners.y[i] < corners.y[j];
    }

    /** The leftmost corner of a closed way is convex: its turn is the way's. */
    private int turn(List<Integer> way, int corner) {
        int k = way.indexOf(corner);
        return corners.turn(
                way.get((k + way.size() - 1) % way.size()), corner, corners.after(corner));
    }

    /**
     * How often a closed way goes round a corner that does not lie on it, 1 for once to the left.
     */
    private int rounds(List<Integer> way, int corner) {
        int rounds = 0;
        double y = corners.y[corner];
        for (int i : way) {
            int j = corners.after(i);
            boolean up = corners.y[i] <= y && y < corners.y[j];
            boolean down = corners.y[j] <= y && y < corners.y[i];
            if (!up && !down) continue;
            int side =
                    Orientation.of(
                            corners.x[i],
                            corners.y[i],
                            corners.x[j],
                            corners.y[j],
                            corners.x[corner],
                            y);
            if (up && side > 0) rounds++;
            if (down && side < 0) rounds--;
        }
        return rounds;
    }
}
