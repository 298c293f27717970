package rasterlab.engine.geometry.meeting;

import java.util.List;
import rasterlab.contract.LinePlane;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that tell where a line meets a plane, in teaching order. */
final class LinePlaneMethods {
    private static final String COURSE =
            "the course's text on analytic geometry, distance from the origin to a plane";

    private LinePlaneMethods() {}

    static List<Method<LinePlane>> all() {
        return List.of(
                new Method<>(
                        "formula-textbook",
                        new About(
                                "μ = (c − n·p₁) / (n·p*), p* = p₂ − p₁",
                                "n·(p₁ + μ·p*) = c",
                                "6 multiplications, 8 additions and a division per line",
                                "a parallel line, where n·p* is 0 and μ no number; a nearly"
                                        + " parallel one; products beyond 10³⁰⁸ or below 10⁻³⁰⁸;"
                                        + " rounding takes a point at p₂ beyond it",
                                COURSE),
                        new TextbookMeeting()),
                new Method<>(
                        "formula",
                        new About(
                                "μ = (c − n·p₁) / (n·p*), products by powers of two near 1",
                                "n·(p₁ + μ·p*) = c",
                                "6 multiplications, 8 additions and a division per line, and"
                                        + " changes of exponents",
                                "a nearly parallel line, where the products cancel; a parallel one"
                                        + " is refused; rounding takes a point at p₂ beyond it",
                                COURSE),
                        new CheckedMeeting()),
                new Method<>(
                        "unrounded",
                        new About(
                                "μ = (c − n·p₁) / (n·p₂ − n·p₁), both sums without error, c = n·a"
                                        + " unrounded where a point a of the plane is given",
                                "n·(p₁ + μ·p*) = c",
                                "9 products with their errors, each added to up to 12 parts",
                                "none known; refuses coordinates more than 2⁴⁰⁰ apart, and a c more"
                                        + " than 2⁹⁰⁰ from the largest n·p",
                                "exact sums after J. R. Shewchuk, Adaptive precision floating-point"
                                        + " arithmetic and fast robust geometric predicates, 1997"),
                        new UnroundedMeeting()));
    }
}
