package rasterlab.engine.light.face;

import java.util.List;
import rasterlab.contract.FaceShader;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class FaceMethods {
    private static final String ARTICLE =
            "article on coordinate systems, section on shading faces (what the books warn of)";

    private FaceMethods() {}

    static List<Method<FaceShader>> all() {
        return List.of(
                method(
                        "flat-textbook",
                        "one intensity by the normal of (x·D/z, y·D/z, z)",
                        "none; the division turns the normal",
                        "1 formula per face",
                        "faces close to the eye and slanted",
                        "student's coursework: three-dimensional model of a vase, section 2.2",
                        new FlatFace(true)),
                method(
                        "flat",
                        "one intensity for the whole face, by its normal, in its middle",
                        "the same everywhere on the face",
                        "1 formula per face",
                        "curved surfaces (edges show as Mach bands), lamps and eyes close by",
                        ARTICLE,
                        new FlatFace(false)),
                method(
                        "gouraud",
                        "I = a·I₁ + b·I₂ + c·I₃ of the three corners' intensities",
                        "never brighter than the brightest corner",
                        "3 formulas per face, 3 multiplications per channel and pixel",
                        "highlights inside a face are lost; slopes jump at edges; sums cut at"
                                + " corners",
                        "H. Gouraud, Continuous shading of curved surfaces, IEEE Transactions on"
                                + " Computers 20(6), 1971",
                        new GouraudFace()),
                method(
                        "phong-textbook",
                        "n = a·n₁ + b·n₂ + c·n₃, not brought to length 1; the formula per pixel",
                        "none; |n| < 1 between corners",
                        "1 formula per pixel",
                        "the farther the corners' normals diverge, the darker the middle",
                        ARTICLE,
                        new ShortNormalFace()),
                method(
                        "phong",
                        "n = (a·n₁ + b·n₂ + c·n₃)/|…|; the formula per pixel",
                        "|n| = 1 everywhere",
                        "1 formula per pixel",
                        "none known where lamp and eye are at least a tenth of the largest"
                                + " coordinate away, mixed normals are as long, the attenuation is at"
                                + " most 10 and, with a shininess below 1, r·v is at least 10⁻⁴ from"
                                + " 0; refuses where mixed normals cancel out",
                        "B. T. Phong, Illumination for computer generated pictures,"
                                + " Communications of the ACM 18(6), 1975",
                        new PhongFace()));
    }

    private static Method<FaceShader> method(
            String name,
            String formula,
            String invariant,
            String cost,
            String failures,
            String source,
            FaceShader implementation) {
        return new Method<>(
                name, new About(formula, invariant, cost, failures, source), implementation);
    }
}
