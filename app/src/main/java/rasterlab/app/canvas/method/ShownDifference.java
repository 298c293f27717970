package rasterlab.app.canvas.method;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;

/**
 * A way in which a tab shows a hazard otherwise than it is.
 *
 * @param parts of the sentence, such as sizes; the texts have them as they are written, and behind
 *     them once more as they are
 */
public record ShownDifference(ShownDifferenceKind kind, List<Object> parts) {
    /** The kind of a difference; each is a sentence. */
    public enum ShownDifferenceKind {
        /** The picture has only those faces of a body that the method calls visible. */
        FACES_FOUND,
        /** A body is drawn whole, since the method calls no face visible or not. */
        FACES_ALL,
        /** Faces without an area are left out. */
        FACES_WITHOUT_AREA,
        /** Coordinates that no eye can look at are made larger or smaller. */
        SCALED,
        /** Polygons are painted in the method's order. */
        PAINTED_IN_ORDER,
        /** Polygons are painted in the order in which they are given, since the method has none. */
        PAINTED_AS_GIVEN,
        /** The picture has another size. */
        PICTURE_SIZE,
        /** A picture that is long and low is made higher. */
        STRETCHED,
        /** A corner is moved, so that its face has an area. */
        CORNER_MOVED,
        /** A corner has its face's normal, since the method's has not the length 1. */
        FACE_NORMAL,
        /** A normal is brought to length 1. */
        NORMAL_LENGTH,
        /** Normals that a method finds are brought to length 1. */
        NORMALS_LENGTHENED,
        /** A lamp stands beside the point that it stands in. */
        LAMP_BESIDE,
        /** The point is not in the middle, at which spots look. */
        POINT_ASIDE,
        /** A colour is brought into the cube. */
        COLOR_CUT,
        /** A point at which is divided by 0 is nowhere. */
        NO_IMAGE,
        /** Many of the method's points that are off cannot be told apart from the exact ones. */
        POINTS_TOGETHER,
        /** The method's point is too far away to be in the picture. */
        POINT_BEYOND,
        /** The lab draws by formulas of its own and has not this method. */
        OTHER_METHOD;

        private String key() {
            return "unlike." + name().toLowerCase(Locale.ROOT).replace('_', '-');
        }
    }

    public ShownDifference {
        parts = List.copyOf(parts);
    }

    public static ShownDifference of(ShownDifferenceKind kind, Object... parts) {
        return new ShownDifference(kind, Arrays.asList(parts));
    }

    /** The sentence in the language of the texts, those of {@code canvas}. */
    String in(Texts texts) {
        Stream<Object> said =
                parts.stream().map(part -> part instanceof Number n ? number(n, texts) : part);
        return texts.text(kind.key(), Stream.concat(said, parts.stream()).toArray());
    }

    private static String number(Number number, Texts texts) {
        return Shown.number(number.doubleValue(), texts.locale());
    }
}
