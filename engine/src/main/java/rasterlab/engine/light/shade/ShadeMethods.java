package rasterlab.engine.light.shade;

import java.util.List;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class ShadeMethods {
    private static final String CHAPTER =
            "Kazantsev, course text on computer graphics, chapter 7, empirical model";

    private ShadeMethods() {}

    static List<Method<PointShader>> all() {
        return List.of(lambert(), phongTextbook(), phong(), blinnPhong());
    }

    private static Method<PointShader> lambert() {
        return new Method<>(
                "lambert",
                new About(
                        "I = E + G·kₐ + f·(Lₐ·kₐ + L_d·k_d·max(0, n·l)), cut to [0, 1]",
                        "n and l have length 1; the eye does not matter",
                        "2 square roots, 1 cosine",
                        "none known up to an attenuation of 10, beyond which roundings grow with"
                                + " it; has no highlights by intention",
                        "J. H. Lambert, Photometria, 1760; " + CHAPTER),
                new FormulaShader(Reflection.LAMBERT));
    }

    private static Method<PointShader> phongTextbook() {
        return new Method<>(
                "phong-textbook",
                new About(
                        "I = I_p·kₐ + I_p/(R + r²)·(k_d·(L, N) + k_m·(R, V)ⁿ), as printed",
                        "none; lengths and signs are taken for granted",
                        "3 cosines, 1 power",
                        "interpolated normals, lights and eyes behind the surface, sums above 1,"
                                + " zero-area faces",
                        CHAPTER),
                new PrintedShader());
    }

    private static Method<PointShader> phong() {
        return new Method<>(
                "phong",
                new About(
                        "lambert + f·L_s·k_s·max(0, r·v)ˢ, r = 2·(n·l)·n − l, where n·l > 0",
                        "n, l and v have length 1, so r has too",
                        "3 square roots, 3 cosines, 1 power",
                        "none known up to an attenuation of 10, beyond which roundings grow with"
                                + " it; refuses a point without a normal",
                        "B. T. Phong, Illumination for computer generated pictures,"
                                + " Communications of the ACM 18(6), 1975"),
                new FormulaShader(Reflection.PHONG));
    }

    private static Method<PointShader> blinnPhong() {
        return new Method<>(
                "blinn-phong",
                new About(
                        "lambert + f·L_s·k_s·max(0, n·h)ˢ, h = (l + v)/|l + v|, where n·l > 0",
                        "n, l, v and h have length 1",
                        "4 square roots, 2 cosines, 1 power",
                        "digits of h are lost where eye and light are almost opposite",
                        "J. F. Blinn, Models of light reflection for computer synthesized pictures,"
                                + " SIGGRAPH 1977"),
                new FormulaShader(Reflection.BLINN_PHONG));
    }
}
