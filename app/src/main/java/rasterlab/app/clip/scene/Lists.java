package rasterlab.app.clip.scene;

import java.util.ArrayList;
import java.util.List;

/** Changed copies of unmodifiable lists. */
final class Lists {
    private Lists() {}

    static <T> List<T> replaced(List<T> list, int index, T element) {
        var copy = new ArrayList<T>(list);
        copy.set(index, element);
        return List.copyOf(copy);
    }

    static <T> List<T> inserted(List<T> list, int index, T element) {
        var copy = new ArrayList<T>(list);
        copy.add(index, element);
        return List.copyOf(copy);
    }

    static <T> List<T> removed(List<T> list, int index) {
        var copy = new ArrayList<T>(list);
        copy.remove(index);
        return List.copyOf(copy);
    }
}
