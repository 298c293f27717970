package rasterlab.app.light;

import java.util.Locale;
import java.util.function.UnaryOperator;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.Substance;

/** Views on which a shading, a normal or a sum fails. */
public enum LightHazard {
    /** The highlight lies inside a face, where Gouraud's shading has no corner. */
    LOST_HIGHLIGHT(
            first ->
                    first.with(new LitBody("sphere", 8, LitBody.OWN))
                            .with(MaterialChoice.of(Substance.RUBY).withShininess(120))),
    /** Few faces: steps by flat shading, bends by Gouraud's. */
    MACH_BANDS(
            first ->
                    first.with(new LitBody("sphere", 14, LitBody.OWN))
                            .with(MaterialChoice.of(Substance.CHALK))
                            .withMach(true)),
    /** Averaged normals make edges round that are none. */
    ROUNDED_CUBE(
            first ->
                    first.with(new LitBody("cube", 12, "angle"))
                            .with(MaterialChoice.of(Substance.TURQUOISE))
                            .withArrows(true)),
    /** Plain means of a cube's normals depend on how its sides are cut. */
    CUT_CUBE(
            first ->
                    first.with(new LitBody("cube", 12, "plain"))
                            .with(MaterialChoice.of(Substance.TURQUOISE))
                            .withArrows(true)),
    /** Sums above 1 are cut: colours turn to white, the form is lost. */
    OVERFLOW(
            first ->
                    first.with(MaterialChoice.of(Substance.BRASS).withAmbient(2))
                            .withAmbient(0.8)
                            .withLamp(0, first.lamps().get(0).withStrength(3))),
    /** Phong's cosine reaches farther round than Blinn's with the same exponent. */
    PHONG_EXPONENT(
            first ->
                    first.with(MaterialChoice.of(Substance.GOLD).withShininess(20))
                            .with(new LitBody("sphere", 40, LitBody.OWN))
                            .with(Reflection.PHONG)),
    /** A cone meets too few corners to be seen by Gouraud's shading. */
    SPOT(
            first ->
                    first.with(new LitBody("sphere", 16, LitBody.OWN))
                            .with(MaterialChoice.of(Substance.SILVER))
                            .withLamp(
                                    0,
                                    first.lamps()
                                            .get(0)
                                            .withKind(Lamp.LampKind.SPOT)
                                            .withCutoff(12)
                                            .withStrength(1.5)));

    private final UnaryOperator<LightChoice> view;

    LightHazard(UnaryOperator<LightChoice> view) {
        this.view = view;
    }

    /** Lower-case name with hyphens, part of keys and component names. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Whether the methods of vertex normals fail here; elsewhere a shading or a sum does. */
    public boolean ofNormals() {
        return shown().body().name().equals("cube");
    }

    /** The choice that shows it. */
    public LightChoice shown() {
        return view.apply(LightChoice.first());
    }
}
