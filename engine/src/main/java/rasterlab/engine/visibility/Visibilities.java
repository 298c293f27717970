package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The visibility methods that can be named, in teaching order. */
public final class Visibilities {
    private static final String COURSEWORK =
            "student's coursework \"three-dimensional model of a vase\"";

    private final List<Method<Visibility>> methods;

    public Visibilities() {
        methods =
                List.of(
                        new Method<>("painter-textbook", textbook(), new TextbookPainter()),
                        new Method<>("painter", painter(), new Painter()),
                        new Method<>("zfloat", zfloat(), new FloatZBuffer()),
                        new Method<>("raycast", raycast(), new RayCast()));
    }

    public List<Method<Visibility>> methods() {
        return methods;
    }

    public List<String> names() {
        return methods.stream().map(Method::name).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public Method<Visibility> named(String name) {
        return Named.find("visibility method", name, methods, Method::name);
    }

    private static About textbook() {
        return new About(
                "depth = (z1 + z2 + z3) / 3 of coordinates rounded to whole units",
                "every face drawn so far has a mean z at least as large as the next",
                "N² comparisons, every pixel of every face is written",
                "rounding moves edges by up to a pixel and merges depths; a mean cannot order faces"
                        + " that overlap in depth",
                COURSEWORK);
    }

    private static About painter() {
        return new About(
                "depth = mean z of all corners in eye space",
                "every face drawn so far has a mean z at least as large as the next",
                "N·log N comparisons, every pixel of every face is written",
                "long faces beside short ones, cyclic overlap, faces that pierce each other",
                COURSEWORK + ", repaired");
    }

    private static About zfloat() {
        return new About(
                "nearness = ρ / z, linear over a plane in pixel coordinates; the larger wins",
                "each pixel holds the nearest of the faces drawn so far",
                "one comparison per pixel of every face",
                "faces closer together than a float can tell; faces in one plane",
                "E. Catmull, PhD thesis, University of Utah, 1974");
    }

    private static About raycast() {
        return new About(
                "t = (c − n·o) / (n·d) for each face; the smallest t inside a face wins",
                "a pixel's answer depends on no other pixel",
                "N plane tests per pixel",
                "none known; slow",
                "A. Appel, AFIPS Spring Joint Computer Conference, 1968");
    }
}
