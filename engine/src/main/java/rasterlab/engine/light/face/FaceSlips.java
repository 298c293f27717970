package rasterlab.engine.light.face;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.SurfaceSlips;
import rasterlab.engine.study.Slip;

/** Faces lit with something left out, taken for something else or the wrong way round. */
final class FaceSlips {
    /** A distance at which the direction to the light is the same from all points. */
    private static final double FAR = 1e60;

    private FaceSlips() {}

    static List<Slip<FaceShader>> of(FaceShader right) {
        List<Slip<FaceShader>> all = new ArrayList<>();
        SurfaceSlips.MATERIALS.forEach(
                (name, change) -> all.add(lit(name, right, face -> material(face, change))));
        SurfaceSlips.LIGHTS.forEach(
                (name, change) -> all.add(lit(name, right, face -> light(face, change))));
        all.add(
                lit(
                        "global-ambient-left-out",
                        right,
                        face ->
                                with(
                                        face,
                                        face.normals(),
                                        face.eye(),
                                        face.material(),
                                        face.light(),
                                        new double[3])));
        all.add(
                lit(
                        "normal-turned-round",
                        right,
                        face -> normals(face, times(face.normals(), -1))));
        all.add(
                lit(
                        "eye-as-direction",
                        right,
                        face ->
                                with(
                                        face,
                                        face.normals(),
                                        times(face.eye(), FAR),
                                        face.material(),
                                        face.light(),
                                        face.globalAmbient())));
        all.add(
                Slip.of(
                        "weights-in-another-order",
                        (face, weights) -> right.shade(face, turned(weights, 1)),
                        (face, weights) -> right.shade(face, turned(weights, 2))));
        for (SlippedLight one : SlippedLight.values()) all.add(Slip.of(one.word(), by(one, right)));
        return all;
    }

    private static FaceShader by(SlippedLight light, FaceShader right) {
        return right instanceof GouraudFace
                ? GouraudMutants.cut(light::sum)
                : FaceMutants.atPoints(FacePoint::unit, light::sum);
    }

    private static Slip<FaceShader> lit(
            String name, FaceShader right, UnaryOperator<LitFace> change) {
        return Slip.of(name, (face, weights) -> right.shade(change.apply(face), weights));
    }

    private static LitFace material(LitFace face, UnaryOperator<SurfaceMaterial> change) {
        return with(
                face,
                face.normals(),
                face.eye(),
                change.apply(face.material()),
                face.light(),
                face.globalAmbient());
    }

    private static LitFace light(LitFace face, UnaryOperator<LightSource> change) {
        return with(
                face,
                face.normals(),
                face.eye(),
                face.material(),
                change.apply(face.light()),
                face.globalAmbient());
    }

    private static LitFace normals(LitFace face, double[] normals) {
        return with(face, normals, face.eye(), face.material(), face.light(), face.globalAmbient());
    }

    private static LitFace with(
            LitFace face,
            double[] normals,
            double[] eye,
            SurfaceMaterial material,
            LightSource light,
            double[] globalAmbient) {
        return new LitFace(
                face.corners(), normals, face.lamp(), eye, material, light, globalAmbient);
    }

    private static double[] times(double[] numbers, double factor) {
        double[] all = numbers.clone();
        for (int i = 0; i < all.length; i++) all[i] *= factor;
        return all;
    }

    /** The three weights of each point so many places further. */
    private static double[] turned(double[] weights, int places) {
        double[] all = weights.clone();
        for (int i = 0; i < all.length; i++) all[i / 3 * 3 + (i + places) % 3] = weights[i];
        return all;
    }
}
