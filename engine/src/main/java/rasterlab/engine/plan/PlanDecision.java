package rasterlab.engine.plan;

import rasterlab.engine.sight.Reason;

/**
 * One choice of a plan.
 *
 * @param subject what it is about: visibility, shading, tessellation, texture, lamps, terms, sight
 * @param chosen the least that is enough
 * @param instead what the full pipeline has there
 * @param reason by which proof or bound
 * @param levels the bound of what it may change, in levels
 * @param pixels the bound of how far it may move things, in pixels
 */
public record PlanDecision(
        String subject,
        String chosen,
        String instead,
        Reason reason,
        double levels,
        double pixels) {

    /** A choice that changes nothing that is seen. */
    static PlanDecision exact(String subject, String chosen, String instead, Reason reason) {
        return new PlanDecision(subject, chosen, instead, reason, 0, 0);
    }

    /** Whether anything is left out. */
    public boolean saves() {
        return !chosen.equals(instead);
    }
}
