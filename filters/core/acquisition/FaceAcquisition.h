#pragma once

#include "FaceCurves.h"
#include "FaceLandmarks.h"
#include "TriangleMesh.h"

namespace mien {

/// The azimuth at which curves are sampled at v (both in radians): t - 0.6 sin t with t = v - pi, 2.5 times denser on
/// the face than an even spacing; 0 at the nose bridge, growing towards the subject's left.
double sampleAzimuth(double v);

/// Measures the 29 boundary curves of a face, its feature points and pupils from a scan with 68 landmarks [S 4.1].
///
/// A sample lies where the horizontal ray from the head's axis leaves the skin, at the height that FaceProfiles gives
/// its curve. The lips are taken as closed: C22 and C22' coincide. Ears are taken off (EarlessSkin).
/// @return nothing, or one sentence that says what is wrong; `face` is then left alone
/// @param nostrils  whether curves go into the nostrils where the rays below the tip of the nose do; else they are
/// bridged
std::string acquireFace(const TriangleMesh& mesh, const FaceLandmarks& landmarks, int pointsPerCurve, FaceCurves& face,
                        bool nostrils = false);

/// The mean of faces measured with the same K: curves, feature addresses and pupils.
/// @return nothing, or one sentence that says which face does not fit the first
std::string meanFace(const std::vector<FaceCurves>& faces, FaceCurves& mean);

/// The mean of a face and its mirror image in x: point j and K - j mirror each other exactly, x is 0 at v = 0 and pi.
FaceCurves symmetrised(const FaceCurves& face);

}  // namespace mien
