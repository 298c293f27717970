package rasterlab.engine.visibility.faces;

import java.util.Arrays;
import rasterlab.engine.study.Deviation;

/** Which faces are visible: an output of topic {@code visible-faces}. */
public final class SeenFaces {
    private final boolean[] visible;

    SeenFaces(boolean[] visible) {
        this.visible = visible;
    }

    public int size() {
        return visible.length;
    }

    public boolean visible(int face) {
        return visible[face];
    }

    SeenFaces first(int count) {
        return new SeenFaces(Arrays.copyOf(visible, Math.min(count, visible.length)));
    }

    /** How many of these exact answers differ, in percent of the faces. */
    Deviation deviation(SeenFaces actual) {
        long missing = 0;
        long extra = 0;
        String first = "";
        for (int face = 0; face < visible.length; face++) {
            boolean told = face < actual.size() && actual.visible[face];
            if (told == visible[face]) continue;
            if (told) extra++;
            else missing++;
            if (first.isEmpty())
                first = "face " + face + (told ? " is not visible" : " is visible");
        }
        long wrong = missing + extra + Math.max(0, actual.size() - visible.length);
        double percent = wrong == 0 ? 0 : 100.0 * wrong / Math.max(1, visible.length);
        return new Deviation(percent, missing, extra, visible.length, first);
    }

    @Override
    public String toString() {
        return Arrays.toString(visible);
    }
}
