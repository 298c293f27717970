package rasterlab.app.cli.render;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import picocli.CommandLine.Option;
import rasterlab.app.cli.console.NameList;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.Stereo;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.exercises.scene.SceneSetting;

/** The options of {@code ./lab render} that say how a scene is drawn. */
final class LookOptions {
    /** Turns off what a scene file turns on. */
    static final String NONE = "none";

    @Option(
            names = "--shading",
            paramLabel = "METHOD",
            description =
                    "${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE}, flat where corners have no"
                            + " normals, phong where highlights or a spot's rim would be lost,"
                            + " otherwise gouraud",
            completionCandidates = EngineNames.OfShadings.class,
            defaultValue = "auto")
    private String shading;

    @Option(
            names = "--texture",
            paramLabel = "FILTER",
            description =
                    "${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE}, mipmap where pixels may step"
                            + " over texels, otherwise linear",
            completionCandidates = EngineNames.OfTextureModes.class,
            defaultValue = "auto")
    private String texture;

    @Option(
            names = "--terms",
            paramLabel = "TERM,…",
            description = "what light is seen: ${COMPLETION-CANDIDATES}; or none; default: all",
            completionCandidates = EngineNames.OfLightTerms.class)
    private List<String> terms;

    @Option(
            names = "--two-sided",
            negatable = true,
            description =
                    "lights back faces with their own material, otherwise like front faces; default:"
                            + " as the scene has it")
    private Boolean twoSided;

    @Option(
            names = "--cull",
            paramLabel = "SIDE",
            description =
                    "does not draw back faces or front faces: ${COMPLETION-CANDIDATES};"
                            + " default: ${DEFAULT-VALUE}",
            completionCandidates = EngineNames.OfCulls.class,
            defaultValue = "none")
    private String cull;

    @Option(
            names = "--hidden-lines",
            paramLabel = "HOW",
            description = "with --shading wire: ${COMPLETION-CANDIDATES}; default: removed",
            completionCandidates = EngineNames.OfHiddenLines.class)
    private String hiddenLines;

    @Option(
            names = "--crease",
            paramLabel = "DEGREES",
            description =
                    "with --shading wire: does not draw edges whose faces meet at a smaller angle"
                            + " than this; silhouettes stay; default: 0")
    private Double crease;

    @Option(
            names = "--outline",
            negatable = true,
            description = "draws the faces' edges, or not; painters only")
    private Boolean outline;

    @Option(
            names = "--clip-plane",
            paramLabel = "A,B,C,D",
            description =
                    "cuts off what has Ax + By + Cz + D below 0, in the world's x, y, z and units;"
                            + " may be given "
                            + ClipPlane.MOST
                            + " times; or none",
            converter = ClipPlaneOption.class)
    private List<ClipPlaneOption.ClipPlaneValue> clipPlanes;

    @Option(
            names = "--depth-cue",
            paramLabel = "SHARE",
            arity = "0..1",
            fallbackValue = "" + DepthCue.USUAL,
            description =
                    "fades what is far into the background, the farthest point by this share;"
                            + " ${FALLBACK-VALUE} if none is given, 0 for no fading")
    private Double depthCue;

    @Option(
            names = "--stereo",
            paramLabel = "KIND",
            description = "for two eyes: ${COMPLETION-CANDIDATES}; or none",
            completionCandidates = EngineNames.OfStereoKinds.class)
    private String stereo;

    @Option(
            names = "--eyes",
            paramLabel = "DISTANCE",
            description =
                    "distance between the eyes, in world units or as an angle at the origin, 3deg;"
                            + " default: a thirtieth of the camera's distance",
            converter = EyesOption.class)
    private EyesOption.Distance eyes;

    /**
     * Makes the look. An option that only another shading, method or projection has a use for is
     * refused on the command line and passed over in the file.
     *
     * @param shown may say what the command line does not
     * @param rho the camera's distance from the origin
     * @throws IllegalArgumentException for an unknown name or a number out of range
     */
    Look look(ShownScene shown, String visibility, Projection projection, double rho) {
        ShadingMethod chosen = shading(shown);
        requireLight(chosen);
        requireWire(chosen);
        Look look =
                Look.of(visibility, chosen)
                        .withTexture(texture(shown))
                        .withLight(seenTerms(shown), sides(shown))
                        .withCull(shown.option("--cull", Cull.named(cull), SceneSetting.CULL))
                        .withWire(wire(shown))
                        .withClipPlanes(planes(shown));
        if (outline == null ? outlines(shown, look) : outline)
            look = outline == null ? look.withOutline() : outlined(look);
        Optional<DepthCue> cue = cue(shown);
        if (cue.isPresent()) look = look.withCue(cue.get());
        Optional<Stereo> eyesApart = stereo(shown, projection, rho);
        return eyesApart.isPresent() ? look.withStereo(eyesApart.get()) : look;
    }

    private List<ClipPlane> planes(ShownScene shown) {
        return clipPlanes == null
                ? shown.settings().get(SceneSetting.CLIP_PLANES).orElse(List.of())
                : ClipPlaneOption.planes(clipPlanes);
    }

    private Optional<DepthCue> cue(ShownScene shown) {
        if (depthCue == null) return shown.settings().get(SceneSetting.DEPTH_CUE);
        return depthCue == 0 ? Optional.empty() : Optional.of(new DepthCue(depthCue));
    }

    private ShadingMethod shading(ShownScene shown) {
        return shown.option("--shading", ShadingMethod.named(shading), SceneSetting.SHADING);
    }

    /** How textures are looked up. */
    TextureMode texture(ShownScene shown) {
        return shown.option("--texture", TextureMode.named(texture), SceneSetting.TEXTURE);
    }

    /**
     * Passes unless textures are asked for on the command line where there are no faces to lay them
     * on.
     *
     * @param laid whether other options say what lies on the faces
     */
    void requireFaces(ShownScene shown, boolean laid) {
        TextureMode mode = texture(shown);
        boolean given = shown.onCommandLine().test("--texture");
        boolean asked = laid || given && mode != TextureMode.AUTO && mode != TextureMode.NONE;
        if (asked && shading(shown) == ShadingMethod.WIRE)
            throw new IllegalArgumentException(
                    "--texture, --texture-image, --wrap and --environment need faces; --shading wire"
                            + " draws nothing but edges");
    }

    /** Wires and tones have no light that could be told anything. */
    private void requireLight(ShadingMethod chosen) {
        boolean wire = chosen == ShadingMethod.WIRE;
        if (terms != null && (wire || chosen == ShadingMethod.TONE)) throw needsLight("--terms");
        if (twoSided != null && wire) throw needsLight("--two-sided");
    }

    private static IllegalArgumentException needsLight(String option) {
        return new IllegalArgumentException(
                option + " needs light: --shading flat, gouraud, phong or auto");
    }

    private static Look outlined(Look look) {
        if (look.shading() == ShadingMethod.WIRE)
            throw new IllegalArgumentException(
                    "--outline needs faces; --shading wire draws nothing but edges");
        return look.withOutline();
    }

    /** Whether the file asks for edges that can be drawn. */
    private static boolean outlines(ShownScene shown, Look look) {
        return shown.settings().get(SceneSetting.OUTLINE).orElse(false)
                && look.shading() != ShadingMethod.WIRE
                && Renderer.drawsOutlines(look.visibility());
    }

    private void requireWire(ShadingMethod chosen) {
        if (chosen == ShadingMethod.WIRE) return;
        if (hiddenLines != null) throw needsWire("--hidden-lines");
        if (crease != null) throw needsWire("--crease");
    }

    private WireStyle wire(ShownScene shown) {
        HiddenLines given = hiddenLines == null ? null : HiddenLines.named(hiddenLines);
        return new WireStyle(
                shown.option(given, SceneSetting.HIDDEN_LINES).orElse(HiddenLines.REMOVED),
                shown.option(crease, SceneSetting.CREASE).orElse(0.0));
    }

    private static IllegalArgumentException needsWire(String option) {
        return new IllegalArgumentException(option + " needs --shading wire");
    }

    private Optional<Stereo> stereo(ShownScene shown, Projection projection, double rho) {
        Optional<Stereo.StereoMode> kind = kind(shown, projection);
        if (kind.isEmpty() && eyes != null)
            throw new IllegalArgumentException("--eyes needs --stereo");
        Double apart = eyes == null ? null : (Double) eyes.units(rho);
        double separation = shown.option(apart, SceneSetting.EYES).orElse(Stereo.USUAL * rho);
        return kind.map(shownAs -> new Stereo(shownAs, separation));
    }

    private Optional<Stereo.StereoMode> kind(ShownScene shown, Projection projection) {
        if (NONE.equals(stereo)) return Optional.empty();
        if (stereo != null) return Optional.of(Stereo.StereoMode.named(stereo));
        return projection == Projection.PERSPECTIVE
                ? shown.settings().get(SceneSetting.STEREO)
                : Optional.empty();
    }

    private Set<LightTerm> seenTerms(ShownScene shown) {
        if (terms == null) return shown.settings().get(SceneSetting.TERMS).orElse(LightTerm.all());
        if (terms.equals(List.of(NONE))) return Set.of();
        Set<LightTerm> seen = new TreeSet<>();
        for (String term : NameList.of("--terms", terms, LightTerm.names()))
            if (!seen.add(LightTerm.named(term)))
                throw new IllegalArgumentException("--terms names '" + term + "' twice");
        return seen;
    }

    private Sides sides(ShownScene shown) {
        return shown.option(twoSided, SceneSetting.TWO_SIDED)
                .map(two -> two ? Sides.TWO : Sides.ONE)
                .orElse(Sides.SCENE);
    }
}
