package rasterlab.tests.frontdoor;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Draws the packages of the four modules as one picture, from the compiled classes.
 *
 * <p>A module is a column, a box in it a storey: its packages use packages of the storeys below,
 * and none of their own.
 */
final class HouseMap {
    /** The modules in the picture, those that use the others first. */
    private static final List<String> MODULES = List.of("app", "grader", "exercises", "engine");

    /** Packages on one line of a box. */
    private static final int ABREAST = 3;

    private static final int COLUMN = 250;
    private static final int GAP = 14;
    private static final int LINE = 18;
    private static final int TOP = 64;

    /**
     * The packages that each package uses, by module; a package is named by the first word below
     * its module.
     */
    private final Map<String, Map<String, Set<String>>> uses = new TreeMap<>();

    private final Map<String, Set<String>> otherModules = new TreeMap<>();
    private final Map<String, Integer> storeys = new TreeMap<>();

    private HouseMap() {}

    /** The picture, as SVG. */
    static String svg() {
        var map = new HouseMap();
        var classes =
                new ClassFileImporter()
                        .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                        .importPackages(
                                "rasterlab.contract",
                                "rasterlab.engine",
                                "rasterlab.exercises",
                                "rasterlab.app",
                                "rasterlab.grader");
        for (JavaClass each : classes) map.add(each);
        return map.picture();
    }

    private record Room(String module, String name) {
        static Optional<Room> of(JavaClass type) {
            String[] words = type.getPackageName().split("\\.");
            if (words.length < 2 || !words[0].equals("rasterlab")) return Optional.empty();
            if (words[1].equals("contract")) return Optional.of(new Room("engine", "contract"));
            if (!MODULES.contains(words[1])) return Optional.empty();
            return Optional.of(new Room(words[1], words.length > 2 ? words[2] : words[1]));
        }
    }

    private void add(JavaClass type) {
        Optional<Room> from = Room.of(type);
        if (from.isEmpty()) return;
        Set<String> used =
                uses.computeIfAbsent(from.get().module, module -> new TreeMap<>())
                        .computeIfAbsent(from.get().name, name -> new TreeSet<>());
        for (var dependency : type.getDirectDependenciesFromSelf())
            Room.of(dependency.getTargetClass()).ifPresent(to -> add(from.get(), to, used));
    }

    private void add(Room from, Room to, Set<String> used) {
        if (!from.module.equals(to.module))
            otherModules.computeIfAbsent(from.module, m -> new TreeSet<>()).add(to.module);
        else if (!from.name.equals(to.name)) used.add(to.name);
    }

    private String picture() {
        int highest = MODULES.stream().mapToInt(this::height).max().orElseThrow();
        int width = GAP + MODULES.size() * (COLUMN + GAP);
        int high = TOP + highest + GAP;
        var body = new ArrayList<String>();
        body.add(
                """
                <svg xmlns="http://www.w3.org/2000/svg" width="%1$d" height="%2$d" viewBox="0 0 %1$d %2$d" \
                font-family="sans-serif" font-size="13" text-anchor="middle">
                <rect width="%1$d" height="%2$d" fill="#ffffff"/>"""
                        .formatted(width, high));
        for (int k = 0; k < MODULES.size(); k++) {
            String module = MODULES.get(k);
            draw(module, GAP + k * (COLUMN + GAP), TOP + highest - height(module), body);
        }
        body.add("</svg>\n");
        return String.join("\n", body);
    }

    private int height(String module) {
        return boxes(module).stream().mapToInt(HouseMap::height).sum();
    }

    private static int height(List<String> lines) {
        return lines.size() * LINE + 16;
    }

    /** The lines of a module's storeys, the highest first. */
    private List<List<String>> boxes(String module) {
        var boxes = new TreeMap<Integer, List<String>>(Collections.reverseOrder());
        for (String room : uses.get(module).keySet())
            boxes.computeIfAbsent(storey(module, room), storey -> new ArrayList<>()).add(room);
        return boxes.values().stream().map(HouseMap::lines).toList();
    }

    private void draw(String module, int left, int top, List<String> body) {
        int middle = left + COLUMN / 2;
        body.add(text(middle, top - 36, "font-size=\"18\" font-weight=\"bold\"", module));
        body.add(text(middle, top - 16, "fill=\"#555555\"", used(module)));
        int y = top;
        for (List<String> lines : boxes(module)) {
            body.add(
                    "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"4\" fill=\"#eef3f8\" stroke=\"#5b7a99\"/>"
                            .formatted(left, y, COLUMN, height(lines) - 6));
            for (int k = 0; k < lines.size(); k++)
                body.add(text(middle, y + 18 + LINE * k, "fill=\"#111111\"", lines.get(k)));
            y += height(lines);
        }
    }

    private String used(String module) {
        Set<String> others = otherModules.getOrDefault(module, Set.of());
        return others.isEmpty() ? "uses no other" : "uses " + String.join(", ", others);
    }

    private static String text(int x, int y, String style, String words) {
        return "<text x=\"%d\" y=\"%d\" %s>%s</text>".formatted(x, y, style, words);
    }

    private static List<String> lines(List<String> rooms) {
        var lines = new ArrayList<String>();
        for (int from = 0; from < rooms.size(); from += ABREAST)
            lines.add(
                    String.join(
                            " · ", rooms.subList(from, Math.min(from + ABREAST, rooms.size()))));
        return lines;
    }

    /** The number of packages below it in the longest chain of uses. */
    private int storey(String module, String room) {
        String key = module + "." + room;
        if (!storeys.containsKey(key))
            storeys.put(
                    key,
                    uses.get(module).get(room).stream()
                            .mapToInt(below -> storey(module, below) + 1)
                            .max()
                            .orElse(0));
        return storeys.get(key);
    }
}
