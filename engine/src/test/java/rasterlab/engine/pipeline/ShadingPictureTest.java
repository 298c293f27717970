package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.Material;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.SphericalView;

/** Pictures against the formula at what each pixel's ray meets. */
class ShadingPictureTest {
    private static final int WIDTH = 120;
    private static final int HEIGHT = 90;

    private final Renderer renderer = new Renderer();

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void phongIsTheFormulaAtEachPixel(LightModel model, String projection, SphericalView camera) {
        Scene scene = LitScenes.shinyBall(model);
        PlainRays rays = rays(scene, projection, camera);
        Raster picture = picture(scene, "phong", projection, camera);
        int[] worst = worst(rays, picture, hit -> formula(scene, rays, hit, projection));
        assertTrue(worst[0] <= 1, worst[0] + " levels off at " + worst[1] + ", " + worst[2]);
        assertTrue(worst[3] > 1500, "only " + worst[3] + " pixels compared");
    }

    static Stream<Arguments> mistakes() {
        Reflection blinn = Reflection.BLINN_PHONG;
        var near = new SphericalView(0.6, 1.1, 1.8);
        var above = new SphericalView(2.5, 0.5, 5);
        var aside = LitScenes.ASIDE;
        String central = "perspective";
        return Stream.of(
                argumentSet(
                        "normals or points are mixed without perspective",
                        LitScenes.lamps(blinn, true, false),
                        central,
                        near),
                argumentSet(
                        "mixed normals are not brought back to length 1",
                        LitScenes.lamps(Reflection.LAMBERT, true, false),
                        central,
                        aside),
                argumentSet(
                        "far viewer is taken for a local one",
                        LitScenes.lamps(blinn, false, false),
                        central,
                        near),
                argumentSet(
                        "mirrored ray is mixed up with the half-way one",
                        LitScenes.lamps(Reflection.PHONG, true, false),
                        central,
                        aside),
                argumentSet(
                        "inside is lit as the outside is",
                        LitScenes.lamps(blinn, true, true),
                        central,
                        above),
                argumentSet(
                        "one-sided inside gets a material of its own",
                        LitScenes.lamps(blinn, true, false),
                        central,
                        above),
                argumentSet("spot light shines all around", LitScenes.spot(), central, aside),
                argumentSet(
                        "parallel picture has an eye at ρ",
                        LitScenes.lamps(blinn, true, true),
                        "parallel",
                        aside),
                argumentSet(
                        "oblique picture is lit in its slanted space",
                        LitScenes.lamps(blinn, true, true),
                        "cavalier",
                        aside));
    }

    private static PlainRays rays(Scene scene, String projection, SphericalView camera) {
        return projection.equals("cavalier")
                ? PlainRays.cavalier(scene, camera.rho(), WIDTH, HEIGHT)
                : new PlainRays(scene, camera, projection.equals("perspective"), WIDTH, HEIGHT);
    }

    private Raster picture(Scene scene, String shading, String projection, SphericalView camera) {
        var request =
                new RenderRequest(
                        scene, Renderer.REFERENCE, shading, projection, camera, WIDTH, HEIGHT);
        return renderer.render(request, () -> false);
    }

    private static int formula(Scene scene, PlainRays rays, PlainRays.Hit hit, String projection) {
        Mesh mesh = scene.mesh();
        var normal = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            int of = axis;
            normal[axis] = rays.mixed(hit, k -> mesh.cornerNormal(hit.face(), k, of));
        }
        return lit(scene, rays, hit, hit.point(), normal, projection);
    }

    private static int lit(
            Scene scene,
            PlainRays rays,
            PlainRays.Hit hit,
            double[] point,
            double[] normal,
            String projection) {
        LightModel model = scene.light().model();
        double[] out = {
            scene.mesh().normalX(hit.face()),
            scene.mesh().normalY(hit.face()),
            scene.mesh().normalZ(hit.face())
        };
        boolean behind = PlainRays.dot(out, rays.toEye(hit.point())) < 0;
        boolean turned = behind && model.twoSided();
        Material side = turned ? scene.finish(0).back() : scene.finish(0).front();
        boolean local = model.localViewer() && projection.equals("perspective");
        return PlainLight.argb(
                PlainLight.at(
                        point,
                        turned ? PlainRays.times(-1, normal) : normal,
                        local ? rays.toEye(point) : rays.toFarEye(),
                        side.surface(),
                        model));
    }

    /** The worst difference inside faces, where it is, and how many pixels were compared. */
    private static int[] worst(
            PlainRays rays, Raster picture, Function<PlainRays.Hit, Integer> expected) {
        int[] worst = new int[4];
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                PlainRays.Hit hit = rays.hit(x, y);
                if (hit == null || !rays.inside(x, y, hit)) continue;
                worst[3]++;
                int levels = levels(expected.apply(hit), picture.argb(x, y));
                if (levels <= worst[0]) continue;
                worst[0] = levels;
                worst[1] = x;
                worst[2] = y;
            }
        return worst;
    }

    private static int levels(int one, int other) {
        int most = 0;
        for (int shift = 0; shift < 32; shift += 8)
            most = Math.max(most, Math.abs((one >>> shift & 255) - (other >>> shift & 255)));
        return most;
    }

    @Test
    @DisplayName("flat face is lit at a corner or by a corner's normal")
    void flatIsTheFormulaAtTheMeanOfTheCorners() {
        Scene scene = LitScenes.shinyBall(LitScenes.lamps(Reflection.PHONG, true, true));
        PlainRays rays = rays(scene, "perspective", LitScenes.ASIDE);
        Raster picture = picture(scene, "flat", "perspective", LitScenes.ASIDE);
        int[] worst = worst(rays, picture, hit -> flat(scene, rays, hit));
        assertTrue(worst[0] <= 1, worst[0] + " levels off at " + worst[1] + ", " + worst[2]);
    }

    private static int flat(Scene scene, PlainRays rays, PlainRays.Hit hit) {
        Mesh mesh = scene.mesh();
        var middle = new double[3];
        for (int k = 0; k < 3; k++) {
            int v = mesh.corner(hit.face(), k);
            double[] corner = {mesh.x(v), mesh.y(v), mesh.z(v)};
            middle = PlainRays.plus(middle, PlainRays.times(1 / 3.0, corner));
        }
        double[] normal = {
            mesh.normalX(hit.face()), mesh.normalY(hit.face()), mesh.normalZ(hit.face())
        };
        return lit(scene, rays, hit, middle, normal, "perspective");
    }

    @Test
    @DisplayName("corners' colours are mixed without perspective, or cut after they are mixed")
    void gouraudMixesTheCutColorsOfCorners() {
        var camera = new SphericalView(0.6, 1.1, 1.8);
        Scene scene = LitScenes.shinyBall(LitScenes.lamps(Reflection.PHONG, true, true));
        PlainRays rays = rays(scene, "perspective", camera);
        Raster picture = picture(scene, "gouraud", "perspective", camera);
        int[] worst = worst(rays, picture, hit -> gouraud(scene, rays, hit));
        assertTrue(worst[0] <= 1, worst[0] + " levels off at " + worst[1] + ", " + worst[2]);
    }

    private static int gouraud(Scene scene, PlainRays rays, PlainRays.Hit hit) {
        Mesh mesh = scene.mesh();
        var sum = new double[3];
        int[] corners = {0, hit.fan(), hit.fan() + 1};
        for (int i = 0; i < 3; i++) {
            int v = mesh.corner(hit.face(), corners[i]);
            double[] point = {mesh.x(v), mesh.y(v), mesh.z(v)};
            var material = scene.finish(0).front().surface();
            LightModel model = scene.light().model();
            double[] rgb = PlainLight.at(point, point, rays.toEye(point), material, model);
            for (int c = 0; c < 3; c++) sum[c] += hit.weights()[i] * Math.min(1, rgb[c]);
        }
        return PlainLight.argb(sum);
    }

    @ParameterizedTest(name = "shading depends on the method of visibility: {0}")
    @MethodSource("zBuffers")
    void methodsAgree(String visibility) {
        Scene scene = LitScenes.shinyBall(LitScenes.lamps(Reflection.PHONG, true, true));
        for (String shading : new String[] {"flat", "gouraud", "phong"}) {
            var request =
                    new RenderRequest(
                            scene, visibility, shading, "perspective", LitScenes.ASIDE, 200, 150);
            var difference =
                    PictureDifference.of(
                            renderer.render(
                                    request.withVisibility(Renderer.REFERENCE), () -> false),
                            renderer.render(request, () -> false));
            assertTrue(difference.share() < 0.0005, shading + ": " + difference.share());
        }
    }

    static Stream<String> zBuffers() {
        return Stream.of("zfloat");
    }

    @Test
    @DisplayName("seams between triangles show")
    void triangleEdgesAreSmooth() {
        Scene scene = LitScenes.shinyBall(LitScenes.lamps(Reflection.PHONG, true, true));
        var camera = new SphericalView(0.6, 1.6, 3);
        PlainRays rays = rays(scene, "perspective", camera);
        Raster picture = picture(scene, "phong", "perspective", camera);
        int seams = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                PlainRays.Hit hit = rays.hit(x + 1e-6, y + 1e-9);
                if (hit == null || rays.inside(x, y, hit) || silhouette(rays, x, y)) continue;
                seams++;
                int expected = formula(scene, rays, hit, "perspective");
                assertTrue(
                        levels(expected, picture.argb(x, y)) <= 1,
                        "pixel (%d, %d) on an edge".formatted(x, y));
            }
        assertTrue(seams > 8, "only " + seams + " pixels on edges");
    }

    private static boolean silhouette(PlainRays rays, int x, int y) {
        for (int dx = -1; dx <= 1; dx += 2)
            for (int dy = -1; dy <= 1; dy += 2) if (rays.hit(x + dx, y + dy) == null) return true;
        return false;
    }

    @Test
    @DisplayName("errors of flat and Gouraud shading are not told")
    void gouraudIsNearerToPhongThanFlat() {
        Scene scene = LitScenes.shinyBall(LitScenes.lamps(Reflection.PHONG, true, true));
        Raster phong = picture(scene, "phong", "perspective", LitScenes.ASIDE);
        double[] means = new double[2];
        String[] cheaper = {"flat", "gouraud"};
        for (int i = 0; i < 2; i++) {
            Raster other = picture(scene, cheaper[i], "perspective", LitScenes.ASIDE);
            for (int p = 0; p < phong.argb().length; p++)
                means[i] += levels(phong.argb()[p], other.argb()[p]);
            System.out.printf(
                    "%s: mean error %.3f levels%n", cheaper[i], means[i] / WIDTH / HEIGHT);
        }
        assertTrue(means[1] < means[0], means[1] + " < " + means[0]);
        assertTrue(means[1] > 0, "Gouraud is Phong");
    }
}
