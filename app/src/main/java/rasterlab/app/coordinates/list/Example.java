package rasterlab.app.coordinates.list;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.engine.naming.Named;

/** Lists that show something, each for the plane or for space. */
public enum Example {
    /** A list whose two readings go different ways to the same picture. */
    TWO_READINGS(
            Subject.SQUARE,
            ListItem.of("TRANSL2D", 4, 1),
            ListItem.of("ROT2D", 40),
            ListItem.of("SCALE2D", 2, 1)),
    /** Matrices of the example above the other way round. */
    OTHER_ORDER(
            Subject.SQUARE,
            ListItem.of("SCALE2D", 2, 1),
            ListItem.of("ROT2D", 40),
            ListItem.of("TRANSL2D", 4, 1)),
    /** T⁻¹ · R · T about the point (3, 2). */
    ABOUT_A_POINT(
            Subject.SQUARE,
            ListItem.of("TRANSL2D", 3, 2),
            ListItem.of("ROT2D", 75),
            ListItem.of("TRANSL2D", -3, -2)),
    /** The course's triangle, turned by 90°. */
    QUARTER_TURN(Subject.TRIANGLE, ListItem.of("ROT2D", 90)),
    /** Two reflections are a turn. */
    TWO_REFLECTIONS(Subject.SQUARE, ListItem.of("REFL2DX"), ListItem.of("REFL2DY")),
    /** [0 1; 2 3] · [1 2; 3 1] = [3 1; 11 7]: the list reads p · M2 · M1. */
    PRODUCT(
            Subject.SQUARE,
            ListItem.of(ListItem.FREE, 1, 2, 0, 3, 1, 0, 0, 0, 1),
            ListItem.of(ListItem.FREE, 0, 1, 0, 2, 3, 0, 0, 0, 1)),
    SHEAR(Subject.SQUARE, ListItem.of("SHEAR2D", 0, 0.8)),
    /** p ≠ 0: the square's parallel sides meet. */
    PROJECTIVE(Subject.SQUARE, ListItem.of(ListItem.FREE, 2, 0, 0.4, 0, 2, 0, 0, 0, 1)),
    /** The two readings in space. */
    SPACE(
            Subject.HOUSE,
            ListItem.of("TRANSL3D", 12, 0, 0),
            ListItem.of("ROT3DZ", 40),
            ListItem.of("SCALE3DX", 1.5)),
    AXIS(Subject.CUBE, ListItem.of("ROTAXIS", 0, 0, 0, 1, 2, 2, 37)),
    /** Two turns by 90° about different axes: order matters. */
    TURNS(Subject.HOUSE, ListItem.of("ROT3DX", 90), ListItem.of("ROT3DY", 90));

    private final Subject subject;
    private final transient List<ListItem> items;

    Example(Subject subject, ListItem... items) {
        this.subject = subject;
        this.items = List.of(items);
    }

    List<ListItem> items() {
        return items;
    }

    /** Lower-case name with hyphens. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    static Example named(String code) {
        return Named.find("example", code, List.of(values()), Example::code);
    }

    /** The first one of that dimension. */
    static Example of(int dimension) {
        return Stream.of(values())
                .filter(each -> each.subject.wire().dimension() == dimension)
                .findFirst()
                .orElseThrow();
    }

    /** The example that a choice shows, if it shows one. */
    static Optional<Example> shown(ListChoice choice) {
        return Stream.of(values())
                .filter(each -> each.items.equals(choice.items()))
                .filter(each -> each.subject == choice.subject())
                .findFirst();
    }

    ListChoice in(ListChoice choice) {
        return choice.with(subject).withItems(items, 0);
    }
}
