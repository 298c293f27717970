package rasterlab.engine.visibility.order;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;

/**
 * Space divided by the planes of polygons: each node has one plane, the polygons in it, and what is
 * on its near and on its far side, cut where it was on both.
 *
 * <p>Nothing on the near side can be hidden by what is on the far side, nor by what is in the
 * plane. "Near" is the side of the eye, or any where the plane holds it. Of polygons in one plane
 * the earlier is painted last, and so is seen.
 *
 * <p>Source: H. Fuchs, Z. M. Kedem, B. F. Naylor, On visible surface generation by a priori tree
 * structures, SIGGRAPH 1980, pp. 124–133.
 */
final class BspTree {
    /** The number of polygons tried for a node's plane; the one that cuts the fewest is taken. */
    private static final int CANDIDATES = 5;

    private static final Comparator<Facet> LATEST_FIRST =
            Comparator.comparingInt(Facet::polygon).reversed();

    private final int mostPieces;
    private final Runnable pulse;
    private final Node root;
    private long comparisons;
    private long splits;
    private int pieces;

    /** One plane and all that was divided by it. */
    private static final class Node {
        final List<Facet> level = new ArrayList<>();
        final List<Facet> near = new ArrayList<>();
        final List<Facet> far = new ArrayList<>();
        Node nearTree;
        Node farTree;
    }

    /**
     * @param mostPieces a list that needs more is refused
     * @param pulse run before each division
     */
    BspTree(List<Facet> facets, int mostPieces, Runnable pulse) {
        this.mostPieces = mostPieces;
        this.pulse = pulse;
        pieces = facets.size();
        root = facets.isEmpty() ? null : divided(facets);
        var undone = new ArrayDeque<Node>();
        if (root != null) undone.add(root);
        while (!undone.isEmpty()) {
            Node node = undone.removeLast();
            if (!node.near.isEmpty()) undone.add(node.nearTree = divided(node.near));
            if (!node.far.isEmpty()) undone.add(node.farTree = divided(node.far));
            node.near.clear();
            node.far.clear();
        }
    }

    private Node divided(List<Facet> facets) {
        pulse.run();
        var node = new Node();
        Facet chosen = chosen(facets);
        for (Facet facet : facets) {
            int sides = facet == chosen ? 0 : sides(chosen, facet);
            if (sides == 0) node.level.add(facet);
            else if (sides == EyePlane.NEAR) node.near.add(facet);
            else if (sides == EyePlane.FAR) node.far.add(facet);
            else cut(facet, chosen.plane(), node);
        }
        return node;
    }

    private void cut(Facet facet, EyePlane plane, Node node) {
        splits++;
        if (++pieces > mostPieces)
            throw new IllegalArgumentException(
                    "%d polygons must need at most %d pieces, got %d"
                            .formatted(pieces - splits, mostPieces, pieces));
        List<Facet> both = facet.cut(plane);
        node.near.add(both.get(0));
        node.far.add(both.get(1));
    }

    private int sides(Facet divider, Facet facet) {
        comparisons++;
        return divider.plane().sides(facet.seen());
    }

    /** The polygon whose plane cuts the fewest others, of a few evenly spread over the list. */
    private Facet chosen(List<Facet> facets) {
        int candidates = Math.min(CANDIDATES, facets.size());
        if (facets.size() <= 2) return facets.get(0);
        Facet best = facets.get(0);
        long least = Long.MAX_VALUE;
        for (int i = 0; i < candidates; i++) {
            Facet candidate = facets.get((int) ((2L * i + 1) * facets.size() / (2 * candidates)));
            long penalty = penalty(candidate, facets);
            if (penalty < least) {
                least = penalty;
                best = candidate;
            }
        }
        return best;
    }

    /** Cuts made, each as bad as eight polygons more on one side than on the other. */
    private long penalty(Facet candidate, List<Facet> facets) {
        long cuts = 0;
        long near = 0;
        long far = 0;
        for (Facet facet : facets) {
            if (facet == candidate) continue;
            int sides = sides(candidate, facet);
            if (sides == EyePlane.NEAR) near++;
            else if (sides == EyePlane.FAR) far++;
            else if (sides != 0) cuts++;
        }
        return 8 * cuts + Math.abs(near - far);
    }

    long comparisons() {
        return comparisons;
    }

    long splits() {
        return splits;
    }

    /** A way through the tree, back to front: far side, plane, near side of each node. */
    BspTraversal tour() {
        return new BspTraversal();
    }

    /** Hands out the pieces one by one. */
    final class BspTraversal {
        private final Deque<Node> undone = new ArrayDeque<>();
        private final Deque<Facet> ready = new ArrayDeque<>();

        private BspTraversal() {
            descend(root);
        }

        private void descend(Node from) {
            for (Node node = from; node != null; node = node.farTree) undone.addLast(node);
        }

        boolean hasNext() {
            return !ready.isEmpty() || !undone.isEmpty();
        }

        Facet next() {
            if (ready.isEmpty()) {
                Node node = undone.removeLast();
                node.level.sort(LATEST_FIRST);
                ready.addAll(node.level);
                descend(node.nearTree);
            }
            return ready.removeFirst();
        }
    }
}
