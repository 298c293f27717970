package rasterlab.grader.institution

/**
 * A sign-in by the institution that does not let anybody in.
 *
 * @param named what the institution calls the person; null where it is not known
 * @param detail for the log, in English
 */
class SignInRefused(
    val why: SignInFault,
    val named: String? = null,
    detail: String = why.code,
    cause: Throwable? = null,
) : Exception(detail, cause)

/** Why nobody is let in; [code] names the words of the page. */
enum class SignInFault(
    val code: String,
) {
    /** The sign-in began in another browser, was finished before, or took too long. */
    STALE("institution-stale"),

    /** The institution did not sign the person in. */
    DENIED("institution-denied"),

    /** The word that came as the institution's is not certainly its own. */
    UNTRUSTED("institution-untrusted"),

    /** The institution does not answer. */
    AWAY("institution-away"),

    /** The institution does not say who the person is. */
    NAMELESS("institution-nameless"),

    /** Nobody here is called so. */
    UNKNOWN("institution-unknown"),

    /** The request did not come through a trusted proxy that names the person. */
    NO_PROXY("institution-no-proxy"),
}
