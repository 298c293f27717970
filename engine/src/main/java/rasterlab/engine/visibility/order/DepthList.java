package rasterlab.engine.visibility.order;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Polygons by their largest depth, the farthest last. */
final class DepthList {
    private final List<FacetExtent> sorted = new ArrayList<>();

    boolean isEmpty() {
        return sorted.isEmpty();
    }

    int size() {
        return sorted.size();
    }

    /** Inserts a polygon before those of the same depth. */
    void add(FacetExtent extent) {
        sorted.add(placeOf(extent.mostZ()), extent);
    }

    /** The first place with at least that depth. */
    private int placeOf(double depth) {
        int low = 0;
        int high = sorted.size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (sorted.get(middle).mostZ() < depth) low = middle + 1;
            else high = middle;
        }
        return low;
    }

    FacetExtent removeFarthest() {
        return sorted.remove(sorted.size() - 1);
    }

    void remove(FacetExtent extent) {
        int place = placeOf(extent.mostZ());
        while (sorted.get(place) != extent) place++;
        sorted.remove(place);
    }

    /**
     * The farthest polygon of which P may hide something. Once one is not as far as P's nearest
     * corner, none before it is.
     */
    Optional<FacetExtent> firstHidden(FacetExtent p, FiveTests tests) {
        for (int i = sorted.size() - 1; i >= 0; i--) {
            FacetExtent q = sorted.get(i);
            if (p.clearlyBehind(q)) return Optional.empty();
            if (tests.mayHide(p, q)) return Optional.of(q);
        }
        return Optional.empty();
    }
}
