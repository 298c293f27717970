package rasterlab.grader.lti

/**
 * A launch that lets nobody in and changes nothing.
 *
 * @param detail for the log, in English
 */
class LtiRefused(
    val why: LtiFault,
    detail: String = why.code,
    cause: Throwable? = null,
) : Exception(detail, cause)

/** Why a launch is refused; [code] names the words of the page. */
enum class LtiFault(
    val code: String,
) {
    /** No platform is registered that calls itself and this server so. */
    UNKNOWN_PLATFORM("lti-platform"),

    /** The launch began in another browser, was finished before, or took too long. */
    STALE("lti-stale"),

    /** The browser has not kept the cookie of the beginning. */
    NO_COOKIE("lti-cookie"),

    /** The platform did not sign the person in. */
    DENIED("lti-denied"),

    /** The word that came as the platform's is not certainly its own, or not for this launch. */
    UNTRUSTED("lti-untrusted"),

    /** The platform's word was good once, and is too old now. */
    EXPIRED("lti-expired"),

    /** The platform has this server in a place that is not registered. */
    DEPLOYMENT("lti-deployment"),

    /** The message is none of LTI 1.3 that this server understands. */
    MESSAGE("lti-message"),

    /** The platform's keys cannot be had just now. */
    AWAY("lti-away"),

    /** The platform gives the person no role that there is here. */
    ROLE("lti-role"),

    /** No instructor has said yet which course here the platform's course is. */
    UNBOUND("lti-unbound"),

    /** The platform's course is another one here than the single one that this person teaches. */
    OTHER_COURSE("lti-other-course"),

    /** The access of this account was taken away here. */
    REVOKED("lti-revoked"),

    /** The token is nobody's of the staff. */
    TOKEN("lti-token"),
}
