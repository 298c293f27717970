package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** Methods that ask of parts of the picture which face is seen there. */
final class ImageMethods {
    private ImageMethods() {}

    static List<Method<Visibility>> all() {
        return List.of(
                new Method<>("scanline", scanLine(), new ScanLine()),
                new Method<>("warnock", warnock(), new Warnock()));
    }

    static Method<Visibility> rayCast() {
        return new Method<>("raycast", rays(), new RayCast());
    }

    private static About scanLine() {
        return new About(
                "between two boundaries on a row the face that is nearest at both ends; two"
                        + " different ones split the span where their planes cross",
                "all pixels left of the present boundary are painted, each once",
                "N·log N for a row of N faces, two depths per active face and span",
                "none known but depths that doubles cannot tell; faces in one plane within"
                        + " rounding: the earlier is shown",
                "C. Wylie, G. Romney, D. Evans, A. Erdahl, AFIPS 1967; G. S. Watkins, PhD thesis,"
                        + " University of Utah, 1970");
    }

    private static About warnock() {
        return new About(
                "a window in which at most one face is left is painted, any other is cut in four",
                "all windows left to look at and all painted ones cover the picture once",
                "4 windows for each that is cut, down to single pixels along visible edges",
                "none known but depths that doubles cannot tell; slow where many edges are seen",
                "J. E. Warnock, PhD thesis, University of Utah, 1969");
    }

    private static About rays() {
        return new About(
                "t = (c − n·o) / (n·d) for each face; the smallest t inside a face wins",
                "a pixel's answer depends on no other pixel",
                "about log N boxes and a few plane tests per pixel",
                "none known but depths that doubles cannot tell; slow; faces in one plane within"
                        + " rounding: the earlier is shown",
                "A. Appel, AFIPS Spring Joint Computer Conference, 1968");
    }
}
