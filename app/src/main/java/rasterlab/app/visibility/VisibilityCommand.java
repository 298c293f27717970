package rasterlab.app.visibility;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rasterlab.app.canvas.file.ShellPath;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.model.SceneText;
import rasterlab.app.visibility.scene.LookChoice;
import rasterlab.app.visibility.scene.SavedScene;
import rasterlab.app.visibility.scene.SceneChoice;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.ClipPlane;

/**
 * The shell commands that draw what the lab shows at one moment, pixel by pixel.
 *
 * @param file that holds the scene, where one does
 * @param zoom by which the pictures are drawn
 * @param width of a picture, in pixels
 * @param height of a picture, in pixels
 * @param outlined the methods whose pictures have edges
 */
record VisibilityCommand(
        VisibilityChoice choice,
        Optional<Path> file,
        double zoom,
        int width,
        int height,
        List<String> outlined) {
    static VisibilityCommand now(VisibilityLabModel model) {
        VisibilityChoice choice = model.state().choice();
        Optional<Raster> picture = model.state().picture().map(Picture::raster);
        return new VisibilityCommand(
                choice,
                file(model),
                model.shownZoom(),
                picture.map(Raster::width).orElse(800),
                picture.map(Raster::height).orElse(600),
                methods(choice).stream().filter(model::drawsEdges).toList());
    }

    /** That holds the scene, where one does. */
    private static Optional<Path> file(VisibilityLabModel model) {
        SceneChoice shown = model.state().choice().shown();
        return shown.file()
                .or(() -> model.saved().filter(one -> one.holds(shown)).map(SavedScene::file));
    }

    private static List<String> methods(VisibilityChoice choice) {
        List<String> known =
                Stream.of(choice.visibility(), choice.comparison())
                        .filter(method -> !method.isEmpty() && !method.equals(OwnMethods.NAME))
                        .toList();
        return known.isEmpty() ? List.of(VisibilityChoice.known(choice.visibility())) : known;
    }

    /** This command for a scene that was saved since. */
    VisibilityCommand drawnFrom(Path saved) {
        return new VisibilityCommand(choice, Optional.of(saved), zoom, width, height, outlined);
    }

    /** A command for each picture on the stage, a line each; or that of the chart. */
    String text() {
        if (choice.view() == StageView.GROWTH)
            return "./lab chart visibility-growth --out visibility-growth.png";
        if (choice.view() == StageView.PRECISION)
            return "./lab chart depth-precision --out depth-precision.png";
        return methods(choice).stream()
                .map(method -> new Line().by(method))
                .collect(Collectors.joining("\n"));
    }

    /**
     * Whether no name and no file brings the scene back, so that it has to be saved first. Needs no
     * command, which takes long for many vertices.
     */
    static boolean needsFile(VisibilityLabModel model) {
        VisibilityChoice choice = model.state().choice();
        return !choice.view().isChart() && !choice.shown().named() && file(model).isEmpty();
    }

    /** Whether a file says more than the scene. */
    private static boolean says(Path file) {
        return file.toString().endsWith(SceneText.EXTENSION);
    }

    /** The name of a scene's files, without their ending. */
    static String stem(String name) {
        return name.replaceFirst("(\\.scene)?\\.[a-zA-Z]+$", "")
                .replaceAll("[^\\p{L}\\p{N}_-]", "-");
    }

    private static String code(Wrap wrap) {
        return wrap.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static String code(Mode mode) {
        return mode.name().toLowerCase(Locale.ROOT);
    }

    /** One command, word by word. */
    private final class Line {
        private final List<String> words = new ArrayList<>(List.of("./lab", "render"));

        private String by(String method) {
            SceneChoice scene = choice.shown();
            words.add(file.map(ShellPath::quoted).orElse(scene.name()));
            if (file.filter(VisibilityCommand::says).isPresent()) words.add("--scene-only");
            scene.up().filter(up -> up != UpAxis.Y).ifPresent(up -> add("--up", up.code()));
            scene.image().ifPresent(image -> add("--texture-image", ShellPath.quoted(image)));
            SphericalView camera = choice.camera();
            choice.tolerance().ifPresentOrElse(this::addPlan, () -> addMethod(method));
            add("--projection", choice.projection());
            add("--camera", camera.thetaRadians() + "," + camera.phiRadians() + "," + camera.rho());
            add("--zoom", zoom);
            add("--size", width + "x" + height);
            if (outlined.contains(method)) words.add("--outline");
            addLook(choice.plain(method, width, height));
            boolean two = !choice.comparison().isEmpty();
            add("--out", stem(scene.name()) + (two ? "-" + method : "") + ".png");
            return String.join(" ", words);
        }

        private void addMethod(String method) {
            add("--visibility", method);
            add("--shading", choice.shading());
        }

        private void addPlan(Tolerance within) {
            add("--visibility", Renderer.AUTO);
            add("--tolerance", within.pixels());
            add("--levels", within.levels());
        }

        private void addLook(RenderRequest request) {
            LookChoice look = choice.look();
            if (request.look().shading() == ShadingMethod.WIRE) addWire(look);
            else addFaces(look, request.look().shading());
            if (look.cull() != Cull.NONE) add("--cull", look.cull().code());
            if (look.cue() > 0) add("--depth-cue", look.cue());
            if (look.near() > 0) add("--near", request.depth().near());
            if (look.far() < Double.POSITIVE_INFINITY) add("--far", request.depth().far());
            for (ClipPlane p : look.clipPlanes())
                add("--clip-plane", p.a() + "," + p.b() + "," + p.c() + "," + p.d());
            request.look()
                    .stereo()
                    .ifPresent(
                            stereo -> {
                                add("--stereo", stereo.kind().code());
                                add("--eyes", stereo.separation());
                            });
        }

        private void addFaces(LookChoice look, ShadingMethod shading) {
            if (choice.shown().textured()) {
                if (look.texture() != TextureMode.AUTO) add("--texture", look.texture().code());
                look.change().wrap().ifPresent(wrap -> add("--wrap", code(wrap)));
                look.change().environment().ifPresent(mode -> add("--environment", code(mode)));
            }
            if (!look.terms().equals(LightTerm.all()) && shading != ShadingMethod.TONE)
                add(
                        "--terms",
                        new TreeSet<>(look.terms())
                                .stream().map(LightTerm::code).collect(Collectors.joining(",")));
            if (look.sides() != Sides.SCENE)
                words.add(look.sides() == Sides.TWO ? "--two-sided" : "--no-two-sided");
        }

        private void addWire(LookChoice look) {
            if (look.hidden() != HiddenLines.REMOVED) add("--hidden-lines", look.hidden().code());
            if (look.crease() > 0) add("--crease", look.crease());
        }

        private void add(String option, Object value) {
            words.add(option);
            words.add(value.toString());
        }
    }
}
