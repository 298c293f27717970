package rasterlab.app.cli;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import picocli.CommandLine.Option;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Cull;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.Stereo;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.wire.HiddenLines;
import rasterlab.engine.pipeline.wire.WireStyle;

/** The options of {@code ./lab render} that say how a scene is drawn. */
final class LookOptions {
    @Option(
            names = "--shading",
            paramLabel = "METHOD",
            description = "${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE}",
            completionCandidates = EngineNames.OfShadings.class,
            defaultValue = "auto")
    private String shading;

    @Option(
            names = "--texture",
            paramLabel = "FILTER",
            description = "${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE}",
            completionCandidates = EngineNames.OfTextureModes.class,
            defaultValue = "auto")
    private String texture;

    @Option(
            names = "--terms",
            paramLabel = "TERM,…",
            split = ",",
            description = "what light is seen: ${COMPLETION-CANDIDATES}; default: all",
            completionCandidates = EngineNames.OfLightTerms.class)
    private List<String> terms;

    @Option(
            names = "--two-sided",
            negatable = true,
            description =
                    "lights backs by their own material, or as fronts; default: as the scene has"
                            + " it")
    private Boolean twoSided;

    @Option(
            names = "--cull",
            paramLabel = "SIDE",
            description =
                    "leaves faces out by the side that is seen: ${COMPLETION-CANDIDATES};"
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
                    "with --shading wire: leaves out edges at which faces meet at less than this"
                            + " angle, but no outlines; default: 0")
    private Double crease;

    @Option(names = "--outline", description = "draws the faces' edges; painters only")
    private boolean outline;

    @Option(
            names = "--depth-cue",
            paramLabel = "SHARE",
            arity = "0..1",
            fallbackValue = "" + DepthCue.USUAL,
            description =
                    "fades what is far into the background, the farthest point by this share;"
                            + " ${FALLBACK-VALUE} if none is given")
    private Double depthCue;

    @Option(
            names = "--stereo",
            paramLabel = "KIND",
            description = "for two eyes: ${COMPLETION-CANDIDATES}",
            completionCandidates = EngineNames.OfStereoKinds.class)
    private String stereo;

    @Option(
            names = "--eyes",
            paramLabel = "DISTANCE",
            description =
                    "of the two eyes, in world units, or as the angle at the origin such as 3deg;"
                            + " default: a thirtieth of the camera's distance",
            converter = EyesOption.class)
    private EyesOption.Distance eyes;

    /**
     * @param shown may say what the command line does not
     * @param rho the camera's distance from the origin
     * @throws IllegalArgumentException for an unknown name or a number out of range
     */
    Look look(ShownScene shown, String visibility, double rho) {
        ShadingMethod chosen = ShadingMethod.named(shown.option("--shading", shading));
        requireLight(chosen);
        Look look =
                Look.of(visibility, chosen)
                        .withTexture(texture(shown))
                        .withLight(seenTerms(), sides())
                        .withCull(Cull.named(cull))
                        .withWire(wire(chosen));
        if (outline) look = outlined(look);
        if (depthCue != null) look = look.withCue(new DepthCue(depthCue));
        return stereo == null ? onePicture(look) : look.withStereo(stereo(rho));
    }

    /** How textures are looked up. */
    TextureMode texture(ShownScene shown) {
        return TextureMode.named(shown.option("--texture", texture));
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
        if (asked && ShadingMethod.named(shown.option("--shading", shading)) == ShadingMethod.WIRE)
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

    private WireStyle wire(ShadingMethod chosen) {
        if (chosen != ShadingMethod.WIRE) {
            if (hiddenLines != null) throw needsWire("--hidden-lines");
            if (crease != null) throw needsWire("--crease");
        }
        return new WireStyle(
                hiddenLines == null ? HiddenLines.REMOVED : HiddenLines.named(hiddenLines),
                crease == null ? 0 : crease);
    }

    private static IllegalArgumentException needsWire(String option) {
        return new IllegalArgumentException(option + " needs --shading wire");
    }

    private Look onePicture(Look look) {
        if (eyes != null) throw new IllegalArgumentException("--eyes needs --stereo");
        return look;
    }

    private Stereo stereo(double rho) {
        return new Stereo(
                Stereo.Kind.named(stereo), eyes == null ? Stereo.USUAL * rho : eyes.units(rho));
    }

    private Set<LightTerm> seenTerms() {
        if (terms == null) return LightTerm.all();
        if (terms.isEmpty())
            throw new IllegalArgumentException(
                    "--terms needs one of " + String.join(", ", LightTerm.names()));
        Set<LightTerm> seen = new TreeSet<>();
        for (String term : terms)
            if (!seen.add(LightTerm.named(term)))
                throw new IllegalArgumentException("--terms names '" + term + "' twice");
        return seen;
    }

    private Sides sides() {
        if (twoSided == null) return Sides.SCENE;
        return twoSided ? Sides.TWO : Sides.ONE;
    }
}
