// SPDX-License-Identifier: Apache-2.0
// Panel of the LIDAR service. MyRobotLab loads this script by its name. The panel's code is in modules loaded later.
angular.module('mrlapp.service.LIDARGui', [])
    .controller('LIDARGuiCtrl', ['$scope', '$timeout', function($scope, $timeout) {
    import(new URL('service/js/sear/lidar/panel.js', document.baseURI)).then(panel => {
        if (!$scope.$$destroyed) {
            panel.open(this, $scope, $timeout)
        }
    }).catch(error => {
        $scope.failed = 'This panel did not load: ' + error.message + '. Reinstall SEAR, then reload this page'
    }).then(() => {
        $scope.$applyAsync()
    })
}])
