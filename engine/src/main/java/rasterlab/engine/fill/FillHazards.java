package rasterlab.engine.fill;

import static rasterlab.engine.study.Verdict.Kind.CRASHED;
import static rasterlab.engine.study.Verdict.Kind.ENDLESS;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

/** Pictures on which methods fail, with what each method is known to make of them. */
final class FillHazards {
    private static final int MAZE = 901;
    private static final String TEXTBOOK = "recursive-textbook";

    private FillHazards() {}

    static List<Hazard<FillTask>> all() {
        return List.of(
                hazard(
                        "hole",
                        task(2, 1, 4, "........ ........ ..####.. ..#..#.. ..####.. ........"),
                        Map.of()),
                hazard("each-pixel-once", task(2, 2, 4, "..... ..... ..... ..... ....."), Map.of()),
                hazard(
                        "large-region",
                        new FillTask(maze(), MAZE - 2, MAZE - 2, '*', 4),
                        Map.of(TEXTBOOK, CRASHED)),
                hazard(
                        "same-colour",
                        new FillTask(List.of("........", "..###...", "........"), 0, 0, '.', 4),
                        Map.of(TEXTBOOK, ENDLESS)),
                hazard(
                        "diagonal-gap-4",
                        task(1, 1, 4, "####.. #..#.. #...#. ##..#. .####. ......"),
                        Map.of()),
                hazard(
                        "diagonal-gap-8",
                        task(1, 1, 8, "####.. #..#.. #...#. ##..#. .####. ......"),
                        Map.of(TEXTBOOK, WRONG)),
                hazard(
                        "corridor-behind",
                        task(1, 1, 4, "#.# #.# #.# #.# #.#"),
                        Map.of(TEXTBOOK, WRONG)),
                hazard(
                        "last-column-behind",
                        task(0, 0, 4, ".... ###. ...."),
                        Map.of(TEXTBOOK, WRONG)),
                hazard("one-pixel", task(0, 0, 8, "."), Map.of()),
                hazard("seed-outside", task(3, 0, 4, "..."), refusedByAll()),
                hazard("connectivity-6", task(0, 0, 6, "..."), refusedByAll()));
    }

    private static FillTask task(int x, int y, int connectivity, String picture) {
        return new FillTask(List.of(picture.split(" ")), x, y, '*', connectivity);
    }

    /** Columns one pixel wide, joined at the top and at the bottom in turn. */
    private static List<String> maze() {
        var rows = new ArrayList<String>();
        for (int y = 0; y < MAZE; y++) {
            var row = new StringBuilder();
            for (int x = 0; x < MAZE; x++) row.append(isOpen(x, y) ? '.' : '#');
            rows.add(row.toString());
        }
        return rows;
    }

    private static boolean isOpen(int x, int y) {
        boolean joined = y == 0 && x % 4 == 2 || y == MAZE - 1 && x % 4 == 0;
        return x % 2 == 1 || joined && x > 0 && x < MAZE - 1;
    }

    /** Methods that are not named are exact. */
    private static Hazard<FillTask> hazard(
            String name, FillTask input, Map<String, Verdict.Kind> failing) {
        var recorded = new HashMap<String, Verdict.Kind>();
        for (var method : FillMethods.all()) recorded.put(method.name(), EXACT);
        recorded.putAll(failing);
        return new Hazard<>(name, input, recorded);
    }

    private static Map<String, Verdict.Kind> refusedByAll() {
        return FillMethods.all().stream().collect(Collectors.toMap(Method::name, m -> REFUSED));
    }
}
